package org.robonewbie.app.command;

import java.util.concurrent.Callable;
import org.robonewbie.app.doctor.Checkup;
import org.robonewbie.app.doctor.Finding;
import org.robonewbie.app.doctor.Verdict;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Checks the installation and says what to mend. */
@Command(
        name = "doctor",
        description = "Check the installation and say what to mend.",
        footer = {
            "",
            "Examples:",
            "  robonewbie doctor",
            "  robonewbie doctor --headless     without studio and browser"
        })
final class DoctorCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Option(names = "--headless", description = "Do not look at studio and browser.")
    private boolean headless;

    @Override
    public Integer call() {
        boolean broken = false;
        for (Finding finding : Checkup.of(headless).findings()) {
            System.out.println(finding.toText());
            broken |= finding.verdict() == Verdict.BROKEN;
        }
        System.out.println(
                broken
                        ? "Something has to be mended: see the lines with FAIL."
                        : "All is well. Start with: robonewbie demo");
        return broken ? ExitCode.SOFTWARE : ExitCode.OK;
    }
}
