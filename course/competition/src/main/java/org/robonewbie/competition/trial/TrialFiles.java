package org.robonewbie.competition.trial;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Output files of a trial.
 *
 * @param recording file of the recording
 * @param logs folder for the output of programs
 * @param work working folder of programs; deleted after the trial
 */
public record TrialFiles(Optional<Path> recording, Path logs, Path work) {

    /**
     * Returns the paths that are hidden from programs: the result folder, which also contains the programs' working folder.
     */
    List<Path> hidden() {
        return List.of(
                Objects.requireNonNullElse(work.toAbsolutePath().normalize().getParent(), work));
    }

    /** Writes the reports of refused connections, if any. */
    void writeNotices(String trial, List<String> notices) throws IOException {
        if (!notices.isEmpty()) {
            Files.write(logs.resolve(trial + "-doors.txt"), notices);
        }
    }
}
