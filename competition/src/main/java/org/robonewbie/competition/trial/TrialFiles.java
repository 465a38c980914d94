package org.robonewbie.competition.trial;

import java.nio.file.Path;
import java.util.Optional;

/**
 * Where a trial puts what it writes.
 *
 * @param recording file for the recording
 * @param logs folder for what programs print
 * @param work folder in which programs work, deleted afterwards
 */
public record TrialFiles(Optional<Path> recording, Path logs, Path work) {}
