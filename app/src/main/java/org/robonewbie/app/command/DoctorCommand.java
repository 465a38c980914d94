package org.robonewbie.app.command;

import java.util.concurrent.Callable;
import org.robonewbie.app.doctor.Checkup;
import org.robonewbie.app.doctor.Finding;
import org.robonewbie.app.doctor.Verdict;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Checks the installation. */
@Command(
        name = "doctor",
        description = "Check the installation, or a computer room before a course, and say what to fix.",
        footer = {
            "",
            "Examples:",
            "  robonewbie doctor",
            "  robonewbie doctor --headless     without studio and browser",
            "  robonewbie doctor --course       on each computer of a room, from an account as students have it",
            "",
            "Exit code: 0 the computer is ready, 1 something has to be fixed first."
        })
final class DoctorCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Option(names = "--headless", description = "Do not look at studio and browser.")
    private boolean headless;

    @Option(
            names = "--course",
            description =
                    "Check also what a course needs: rights, start time, graphics, a project and an exercise without a network.")
    private boolean course;

    @Override
    public Integer call() {
        return course
                ? report(Checkup.ofRoom(headless), "This computer is ready for the course.")
                : report(Checkup.of(headless), "All is well. Start with: robonewbie demo");
    }

    /** Prints the findings one by one, then the verdict. */
    private static int report(Checkup checkup, String success) {
        ProgramName word = ProgramName.here();
        Verdict worst = Verdict.WELL;
        for (Finding finding : checkup.findings()) {
            System.out.println(word.in(finding.toText()));
            worst = finding.verdict().compareTo(worst) > 0 ? finding.verdict() : worst;
        }
        System.out.println(
                switch (worst) {
                    case WELL -> word.in(success);
                    case NOTABLE -> "It works, but not all of it: the lines with \"look\" say what to know.";
                    case BROKEN -> "Something has to be fixed: see the lines with FAIL.";
                });
        return worst == Verdict.BROKEN ? ExitCode.SOFTWARE : ExitCode.OK;
    }
}
