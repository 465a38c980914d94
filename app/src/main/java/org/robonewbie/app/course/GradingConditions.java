package org.robonewbie.app.course;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * How a program is graded.
 *
 * @param seeds how many trials, with the seeds 1, 2, 3 and so on
 * @param trialsAtOnce how many of them at once, at least 1
 * @param classPath folders and jars with the student's classes
 * @param folder working directory of the program, where its motions are
 * @param isCopy whether the folder is a copy in which only this program works
 * @param recording where the first trial is recorded, if at all
 * @param output hears each line that the program's process prints
 */
public record GradingConditions(
        int seeds,
        int trialsAtOnce,
        String classPath,
        Path folder,
        boolean isCopy,
        Optional<Path> recording,
        Consumer<String> output) {

    /** The folder in which only this program works, if it has one. */
    Optional<Path> ownFolder() {
        return Optional.of(folder).filter(own -> isCopy);
    }
}
