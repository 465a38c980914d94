package org.robonewbie.simulator.export;

/** What surrounds the robot in an MJCF file. */
public enum ExportedScene {
    /** The beginners' pitch with lines, goals and a ball. */
    PITCH,
    /** The ground. */
    PLAIN
}
