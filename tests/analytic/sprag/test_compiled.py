"""Machine code on a machine that keeps nothing."""

from numba.core.caching import CacheImpl

from analytic.sprag.engagement import compiled


def doubled(x: float) -> float:
    return 2.0 * x


def test_where_no_folder_can_be_written_code_is_made_anew(monkeypatch):
    monkeypatch.setattr(CacheImpl, "_locator_classes", [])
    assert compiled(doubled)(2.0) == 4.0
