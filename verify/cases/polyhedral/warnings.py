"""Warnings on the fillets and rollers of a polyhedral ring."""

STATIC_RATING = 4e9  # Pa, ISO 76: roller bearings at their static load rating
STRAINED = 3e-3  # hoop strain at which most steels yield


def of_fillets(stress: float, *, E: float, R_p: float | None, when: str) -> list[str]:
    """Warnings if the hoop stress [Pa] in the fillets is too large; `when` states the loads."""
    stressed = f"the hoop stress of {stress / 1e6:.4g} MPa in the fillets{when}"
    if R_p is not None and stress > R_p:
        return [f"{stressed} exceeds R_p = {R_p / 1e6:.4g} MPa: the ring yields in the fillets"]
    if R_p is None and stress > STRAINED * E:
        return [
            f"{stressed} corresponds to a strain of {stress / E:.2%}: most steels yield at a "
            "smaller strain; enter the yield strength R_p"
        ]
    return []


def of_rollers(p_0: float, where: str = "") -> list[str]:
    """Warnings if the pressure [Pa] of rollers is too large; `where` names the contact."""
    if not p_0 > STATIC_RATING:
        return []
    return [
        f"p_0 = {p_0 / 1e6:.4g} MPa{where} exceeds 4000 MPa, the static load rating of hardened "
        "rollers (ISO 76)"
    ]
