"""The page in a browser: form, answer, finite elements, sweep, files, tabs, keys."""

import json
import time
from pathlib import Path
from typing import Any

import pytest

from tests.verify.page.conftest import Server, missing
from verify.core.inputs import read_parameter_file

if reason := missing():
    pytest.skip(reason, allow_module_level=True)

from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from tests.verify.page.browsing import Browser

SLOW = """import time
import verify.case as vc


class Slow(vc.Case):
    \"\"\"Twice a length.\"\"\"

    title = "Twice a length"
    source = "a test"
    a: float = vc.given("10 mm", "mm", "a", "length", gt=0)

    @vc.Quantity("b", "mm", "twice the length", equation="1")
    def b(self) -> float:
        time.sleep(2)
        return 2 * self.a

    def reference(self, level: int) -> vc.Level:
        return vc.solved(1 / level, b=2 * self.a)

    def comparisons(self):
        yield vc.approximation(Slow.b, order=2, expected=vc.Expected(-0.1, 0.1, "a test"))
"""
pytestmark = pytest.mark.slow("a browser opens the page")


@pytest.fixture
def page(driver: Any, server: Server) -> Browser:
    found = Browser(driver, server.address)
    found.open()
    return found


def test_the_answer_follows_what_is_typed_in_any_unit(page: Browser) -> None:
    page.until(lambda: "Holds" in page.verdict)
    page.type("p_i", "600 MPa")
    page.until(lambda: "Fails" in page.verdict)
    page.type("p_i", "80 N/mm^2")
    page.until(lambda: "Holds" in page.verdict)
    page.type("p_i", "87 ksi")
    page.until(lambda: "Fails" in page.verdict)


def test_a_number_alone_is_in_the_unit_of_its_field_and_gets_it(page: Browser) -> None:
    page.type("p_i", "600")
    page.until(lambda: "Fails" in page.verdict)
    page.until(lambda: page.message("p_i") == "read as 600 MPa")
    page.type("r_i", "19")
    assert page.value("p_i") == "600 MPa"
    assert page.message("p_i") == ""
    page.until(lambda: page.state and page.state.raw["r_i"] == "19 mm")
    page.type("nu", "0.29")
    page.until(lambda: page.state and page.state.raw["nu"] == "0.29")
    assert (page.value("r_i"), page.value("nu")) == ("19 mm", "0.29")


def test_an_error_stands_at_its_input_and_goes_when_it_is_mended(page: Browser) -> None:
    page.type("r_i", "19 kg")
    page.until(lambda: "is not a length" in page.message("r_i"))
    assert page.input("r_i").get_attribute("aria-invalid") == "true"
    assert "No answer" in page.verdict
    page.type("r_i", "19 mm")
    page.until(lambda: page.message("r_i") == "" and "Holds" in page.verdict)


def test_a_warning_stands_beside_the_input(page: Browser) -> None:
    page.type("E", "500 GPa")
    page.until(lambda: "outside the usual range" in page.message("E"))
    assert page.verdict


def test_the_input_that_is_edited_is_marked_in_the_sketch(page: Browser) -> None:
    for place, symbol, other in (("r_o", "ro", "r_i"), ("r_i", "ri", "r_o")):
        page.input(place).click()
        page.until(lambda: page.all(f'.sketch [data-input="{place}"].on'))  # noqa: B023
        assert page.text(".sketch .on text").startswith(symbol)
        assert not page.all(f'.sketch [data-input="{other}"].on')


def test_undo_and_redo_by_keys(page: Browser) -> None:
    page.type("nu", "0.29")
    page.until(lambda: page.one("#undo").is_enabled())
    page.input("nu").send_keys(Keys.CONTROL, "z")
    page.until(lambda: page.value("nu") == "0.3")
    page.until(lambda: page.driver.switch_to.active_element.get_attribute("id") == "in-nu")
    page.until(lambda: page.one("#redo").is_enabled())
    page.press("redo")
    page.until(lambda: page.value("nu") == "0.29")


def test_finite_elements_have_progress_and_judged_rows(page: Browser) -> None:
    page.unfold("tool-fem")
    page.press("fem")
    page.until(lambda: page.all("#fem-rows table"), 300)
    assert "PASS" in page.text("#fem-rows")
    assert "done in" in page.text("#fem-progress")


def test_finite_elements_are_cancelled_and_the_page_stays_usable(page: Browser) -> None:
    page.choose("freewheel-clutch")
    page.type("R", "16.7123 mm")  # nothing is stored for it
    page.unfold("tool-fem")
    page.press("fem")
    page.until(lambda: page.one("#fem-cancel").is_enabled())
    page.type("T", "21 N m")
    page.until(lambda: page.verdict)
    page.press("fem-cancel")
    page.until(lambda: "cancelled" in page.text("#fem-progress"), 30)
    assert page.one("#fem").is_enabled()


def test_a_sweep_draws_a_figure_and_names_points_without_a_result(page: Browser) -> None:
    page.unfold("tool-sweep")
    Select(page.one("#sweep-first")).select_by_value("r_i")
    page.one("#sweep-values").send_keys("15mm:30mm:6")
    page.press("sweep")
    page.until(lambda: page.all("#sweep-figure canvas"))
    assert "points without a result" in page.text("#sweep-figure")


def test_a_wrong_sweep_is_an_error_of_one_line(page: Browser) -> None:
    page.unfold("tool-sweep")
    page.one("#sweep-values").send_keys("1:2")
    page.press("sweep")
    page.until(lambda: "write NAME=a:b:n" in page.text("#sweep-progress"))


def test_two_variants_stand_side_by_side(page: Browser) -> None:
    page.unfold("tool-compare")
    page.press("keep")
    page.type("p_i", "600 MPa")
    page.until(lambda: "fails" in page.text("#compared") and "holds" in page.text("#compared"))
    assert "600 MPa" in page.text("#compared")


def test_a_file_is_saved_as_the_command_line_reads_it_and_loaded(
    page: Browser, server: Server
) -> None:
    page.type("nu", "0.28")
    page.until(lambda: page.one("#undo").is_enabled())
    page.unfold("tool-file")
    page.press("save")
    page.until(lambda: "saved" in page.text("#file-status"))
    case, _, raw = read_parameter_file(server.folder / "my-ring-lame.toml")
    assert (case, raw["nu"]) == ("ring-lame", 0.28)
    page.press("save")
    page.until(lambda: "exists already" in page.text("#file-status"))
    page.open("contact-flat")
    page.unfold("tool-file")
    Select(page.one("#load-name")).select_by_value("my-ring-lame.toml")
    page.press("load")
    page.until(lambda: page.value("nu") == "0.28")


def test_a_file_outside_the_folder_is_not_written(page: Browser, server: Server) -> None:
    page.unfold("tool-file")
    name = page.one("#save-name")
    name.send_keys(Keys.CONTROL, "a")
    name.send_keys("../out.toml")
    page.press("save")
    page.until(lambda: "only files in the folder" in page.text("#file-status"))
    assert not (server.folder.parent / "out.toml").exists()


def test_a_file_outside_the_folder_is_not_opened(page: Browser, server: Server) -> None:
    secret = server.folder.parent / "secret.toml"
    secret.write_text('case = "ring-lame"\nname = "secret"\n[inputs]\nr_i = "1 mm"\n', "utf-8")
    page.unfold("tool-file")
    forged = """const list = document.getElementById("load-name");
    list.add(new Option("x", "../secret.toml")); list.value = "../secret.toml";
    list.dispatchEvent(new Event("change", { bubbles: true }))"""
    page.driver.execute_script(forged)
    page.press("load")
    page.until(lambda: "only files in the folder" in page.text("#file-status"))
    assert page.value("r_i") != "1 mm"


def test_a_slow_answer_blocks_no_typing_and_marks_the_answer_before(
    driver: Any, server: Server
) -> None:
    (server.folder / "slow.py").write_text(SLOW, "utf-8")
    page = Browser(driver, server.address)
    page.open("slow.py")
    page.unfold_all()
    page.until(lambda: "20" in page.text("#answer table"))
    page.type("a", "30 mm")
    page.until(lambda: "answer below is that of the inputs before" in page.text("#busy"))
    start = time.monotonic()
    page.type("a", "400 mm")
    assert page.value("a") == "400 mm"
    assert time.monotonic() - start < 2  # each answer takes longer
    assert "800" not in page.text("#answer table")
    page.until(lambda: "800" in page.text("#answer table"))
    page.until(lambda: page.text("#busy") == "")
    assert page.value("a") == "400 mm"


def test_the_address_reproduces_the_session_in_another_tab(page: Browser) -> None:
    page.type("r_i", "18.5 mm")
    page.until(lambda: page.state and page.state.raw["r_i"] == "18.5 mm")
    first = page.driver.current_window_handle
    before = page.driver.current_url
    page.driver.switch_to.new_window("tab")
    page.driver.get(before)
    page.until(lambda: page.value("r_i") == "18.5 mm")
    page.type("r_i", "17 mm")
    page.until(lambda: page.state and page.state.raw["r_i"] == "17 mm")
    page.driver.close()
    page.driver.switch_to.window(first)
    assert page.value("r_i") == "18.5 mm"  # each tab has a session


def test_the_page_is_used_with_the_keyboard_alone(page: Browser) -> None:
    seen: list[str] = []
    for _ in range(60):
        active = page.driver.switch_to.active_element
        active.send_keys(Keys.TAB)
        now = page.driver.switch_to.active_element
        seen.append(now.get_attribute("id") or now.get_attribute("class") or now.tag_name)
        if "in-r_i" in seen[-1]:
            break
    assert {"case", "in-r_i"} <= set(seen)
    page.driver.switch_to.active_element.send_keys(Keys.CONTROL, "a")
    page.driver.switch_to.active_element.send_keys("26.0 mm")
    page.until(lambda: "Fails" in page.verdict)
    width = "return getComputedStyle(document.activeElement).outlineWidth"
    assert page.driver.execute_script(width) == "3px"


def test_a_table_gains_and_loses_an_entry(page: Browser) -> None:
    page.choose("rotor-system")
    count = len(page.all('[data-at^="supports["][data-at$=".k"]')) or len(page.all(".entry"))
    before = len(page.all(".entry"))
    page.all('[data-action="add"]')[0].click()
    page.until(lambda: len(page.all(".entry")) == before + 1)
    page.all('[data-action="remove"]')[0].click()
    page.until(lambda: len(page.all(".entry")) == before)
    assert count


def test_the_report_is_written_and_shown(page: Browser) -> None:
    page.unfold("tool-report")
    page.press("report")
    page.until(lambda: page.all("#report-files iframe"), 300)
    assert {"report.html", "report.pdf", "rows.csv"} <= set(page.text("#report-files a").split())
    page.driver.switch_to.frame(page.one("#report-files iframe"))
    assert "ring" in page.text("body")
    page.driver.switch_to.default_content()


def test_a_field_is_displayed_in_space_with_its_scale_and_view(page: Browser) -> None:
    page.unfold("tool-shape")
    page.press("fields")
    page.until(lambda: page.all("#shape-figure canvas"), 300)
    assert page.text("#shape-times") == "× 200"
    largest = page.text("#shape-range")
    page.one("#shape-scale").send_keys(Keys.HOME)
    page.until(lambda: page.text("#shape-times") == "× 0")
    figure = page.one("#shape-figure")
    bore = "const d = arguments[0]._fullData[0]; return Math.hypot(d.x[0], d.y[0])"
    page.until(lambda: page.driver.execute_script("return arguments[0].data.length", figure) == 2)
    at_rest = page.driver.execute_script(bore, figure)
    page.one("#shape-scale").send_keys(Keys.END)
    page.until(lambda: page.driver.execute_script(bore, figure) > 1.01 * at_rest)
    Select(page.one("#shape-view")).select_by_value("from above")
    eye = "return arguments[0]._fullLayout.scene.camera.eye"
    page.until(lambda: page.driver.execute_script(eye, figure)["y"] > 0.99)
    Select(page.one("#shape-field")).select_by_value("1")
    page.until(lambda: page.text("#shape-range") != largest)
    forged = """const list = document.getElementById("shape-field");
    list.add(new Option("x", "../x")); list.value = "../x";
    list.dispatchEvent(new Event("change", { bubbles: true }))"""
    page.driver.execute_script(forged)
    for text in ("9" * 400, "9" * 5000):
        page.driver.execute_script(
            """const slider = document.getElementById("shape-scale");
            slider.type = "text"; slider.value = arguments[0];
            slider.dispatchEvent(new Event("change", { bubbles: true }))""", text
        )  # fmt: skip
    page.type("p_i", "55 MPa")
    page.until(lambda: "of earlier inputs" in page.text("#fields-old"))


def test_the_selection_of_another_case_cancels_its_job(page: Browser, server: Server) -> None:
    for case in ("polyhedral-clutch", "polyhedral-locking", "contact-flat"):
        page.choose(case)
        page.unfold("tool-shape")
        page.press("fields")
    page.until(lambda: page.all("#shape-figure canvas"), 300)
    assert "τ/p_0" in page.text("#shape-range")
    assert "deleted" not in server.text


def test_a_case_without_fields_states_this(page: Browser) -> None:
    page.choose("rotor-system")
    page.unfold("tool-shape")
    page.press("fields")
    page.until(lambda: "no field to display" in page.text("#fields-progress"))


def test_no_request_leaves_the_machine(page: Browser, server: Server) -> None:
    page.choose("sprag-clutch")
    found = [json.loads(e["message"])["message"] for e in page.driver.get_log("performance")]
    asked = [m["params"]["request"]["url"] for m in found
             if m["method"] == "Network.requestWillBeSent"]  # fmt: skip
    asked += [m["params"]["url"] for m in found if m["method"] == "Network.webSocketCreated"]
    mine = (f"http://127.0.0.1:{server.port}/", f"ws://127.0.0.1:{server.port}/", "data:", "blob:")
    assert len(asked) > 5
    assert [url for url in asked if not url.startswith(mine)] == []


def test_nothing_is_logged_as_an_error(page: Browser, server: Server) -> None:
    severe = [e["message"] for e in page.driver.get_log("browser") if e["level"] == "SEVERE"]
    assert severe == []
    assert "Traceback" not in server.text
    assert "ERROR" not in server.text.upper()


def test_a_server_that_is_started_again_asks_for_its_token_and_keeps_the_inputs(
    driver: Any, tmp_path: Path
) -> None:
    first = Server(tmp_path)
    page = Browser(driver, first.address)
    page.open()
    page.type("r_i", "18.25 mm")
    page.until(lambda: page.state and page.state.raw["r_i"] == "18.25 mm")
    assert first.end() == 0
    second = Server(tmp_path, first.port)
    try:
        page.until(lambda: page.all('input[name="token"]'))
        page.one('input[name="token"]').send_keys(second.address.partition("token=")[2], Keys.ENTER)
        page.until(lambda: page.verdict)
        assert page.value("r_i") == "18.25 mm"
    finally:
        second.end()
    page.driver.get_log("browser")  # of the time without a server
