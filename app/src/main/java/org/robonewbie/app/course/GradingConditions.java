package org.robonewbie.app.course;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.programs.process.Sandbox;

/**
 * How a program is graded.
 *
 * @param seeds how many trials, with the seeds 1, 2, 3 and so on
 * @param trialsAtOnce how many of them at once, at least 1
 * @param sandbox where the program runs, if there is a sandbox
 * @param recording where the first trial is recorded, if at all
 * @param output receives each line that the program's process prints
 */
public record GradingConditions(
        int seeds, int trialsAtOnce, Sandbox sandbox, Optional<Path> recording, Consumer<String> output) {}
