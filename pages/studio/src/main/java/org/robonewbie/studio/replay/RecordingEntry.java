package org.robonewbie.studio.replay;

import org.robonewbie.simulator.file.RecordingAbout;

/**
 * A recording in a {@link RecordingStore}.
 *
 * @param name its unique name
 * @param bytes its size
 * @param running whether it is still being recorded
 * @param ofProject whether it belongs to the user's current project
 * @param about its metadata
 */
public record RecordingEntry(String name, long bytes, boolean running, boolean ofProject, RecordingAbout about) {}
