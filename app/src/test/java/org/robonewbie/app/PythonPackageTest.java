package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Runs the tests of the Python package, where Python with Gymnasium is installed. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the launcher of this test is a shell script")
@Tag("slow")
class PythonPackageTest {

    @Test
    void packagePassesItsOwnTests() throws Exception {
        Python python = new Python(Python.PACKAGE);
        python.skipWithout("gymnasium, numpy");

        ProcessResult result = python.run("-m", "unittest", "discover", "-v", "-s", "tests");

        assertThat(result.code()).as(result.printed()).isZero();
        assertThat(result.printed()).containsPattern("Ran \\d+ tests").contains("OK");
        if (System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null) {
            assertThat(result.printed().lines().filter(line -> line.contains(" skipped ")))
                    .as("PyTorch, LeRobot and MJX are large, and the nightly workflow has them")
                    .allMatch(
                            line -> line.matches(".*(torch|stable-baselines3|lerobot|mujoco-mjx) is not installed.*"));
        }
    }
}
