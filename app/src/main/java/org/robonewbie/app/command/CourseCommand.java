package org.robonewbie.app.command;

import java.util.concurrent.Callable;
import org.robonewbie.app.doctor.Checkup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** What a teacher does with a whole course. */
@Command(
        name = "course",
        description = {
            "Check whether this computer is ready for a course: Java, ports, rights, start time, browser and graphics, a project and"
                    + " an exercise without a network. Run it on each computer, from an account as students have it."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie course --check",
            "  robonewbie course --check --headless    without studio and browser",
            "",
            "Exit code: 0 the computer is ready, 1 something has to be mended first."
        })
final class CourseCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Option(names = "--check", description = "Check this computer, which the command does without it too.")
    @SuppressWarnings("UnusedVariable") // what the option asks for is what the command does
    private boolean check = true;

    @Option(names = "--headless", description = "Do not look at studio, browser and graphics.")
    private boolean headless;

    @Override
    public Integer call() {
        return DoctorCommand.report(Checkup.ofRoom(headless), "This computer is ready for the course.");
    }
}
