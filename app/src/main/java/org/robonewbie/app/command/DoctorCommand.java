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
        return report(Checkup.of(headless), "All is well. Start with: robonewbie demo");
    }

    /** Prints each finding as soon as it is there, and then whether all is well. */
    static int report(Checkup checkup, String success) {
        CommandWord word = CommandWord.here();
        Verdict worst = Verdict.WELL;
        for (Finding finding : checkup.findings()) {
            System.out.println(word.in(finding.toText()));
            worst = finding.verdict().compareTo(worst) > 0 ? finding.verdict() : worst;
        }
        System.out.println(
                switch (worst) {
                    case WELL -> word.in(success);
                    case NOTABLE -> "It works, but not all of it: the lines with \"look\" say what to know.";
                    case BROKEN -> "Something has to be mended: see the lines with FAIL.";
                });
        return worst == Verdict.BROKEN ? ExitCode.SOFTWARE : ExitCode.OK;
    }
}
