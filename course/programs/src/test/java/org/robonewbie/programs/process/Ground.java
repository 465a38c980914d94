package org.robonewbie.programs.process;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

/** Where the programs of a test run. */
enum Ground {
    OPEN,
    FENCED;

    /** Returns the sandbox, or skips the test where it is missing. */
    Sandbox sandbox() {
        Sandbox found = this == OPEN ? Sandbox.none("of this test") : Sandbox.find();
        boolean required = System.getenv("ROBONEWBIE_REQUIRE_TOOLS") != null;
        assumeTrue(this == OPEN || found.isUp() || required, () -> "no sandbox here: " + found.absence());
        return found;
    }
}
