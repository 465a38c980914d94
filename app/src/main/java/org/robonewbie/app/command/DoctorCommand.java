package org.robonewbie.app.command;

import java.util.concurrent.Callable;
import org.robonewbie.app.doctor.Checkup;
import org.robonewbie.app.doctor.Finding;
import org.robonewbie.app.doctor.Verdict;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code robonewbie doctor}: checks the installation. */
@Command(
        name = "doctor",
        description = "Check this computer, or each computer of a room before a course, and report what needs fixing.",
        footer = {
            "",
            "Examples:",
            "  robonewbie doctor",
            "  robonewbie doctor --headless     skip the studio and the browser",
            "  robonewbie doctor --course       on each computer in the room, logged in as a student",
            "",
            "Exit code: 0 if the computer is ready, 1 if something must be fixed first."
        })
final class DoctorCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Option(names = "--headless", description = "Skip the checks of the studio and the browser.")
    private boolean headless;

    @Option(
            names = "--course",
            description = "Also check what a course needs: permissions, start time, graphics, and whether a project and"
                    + " an exercise work offline.")
    private boolean course;

    @Override
    public Integer call() {
        return course
                ? report(Checkup.ofRoom(headless), "This computer is ready for the course.")
                : report(Checkup.of(headless), "No problems were found. Start with: robonewbie demo");
    }

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
                    case NOTABLE -> "RoboNewbie works, with limitations: see the lines marked \"look\".";
                    case BROKEN -> "Something must be fixed first: see the lines marked FAIL.";
                });
        return worst == Verdict.BROKEN ? ExitCode.SOFTWARE : ExitCode.OK;
    }
}
