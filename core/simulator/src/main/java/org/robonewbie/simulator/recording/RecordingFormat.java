package org.robonewbie.simulator.recording;

/** The numbers that writer and reader of a recording agree on; {@code docs/recording-format.md} describes them. */
final class RecordingFormat {

    static final String MAGIC = "RoboNewbie recording\n";
    static final int VERSION = 1;

    static final int HEADER = 1;
    static final int GAME = 2;
    static final int ROBOTS = 3;
    static final int COMMANDS = 4;
    static final int EVENT = 5;
    static final int CYCLE = 6;

    /** Stands only before a part of a recording that is sent to a page, never in a file. */
    static final int STATE = 7;

    /** What else stands on the pitch; not in the recording of a soccer match. */
    static final int THINGS = 8;

    /** A thing that has been moved. */
    static final int MOVED_THING = 9;

    /** Positions are kept in steps of 0.1 mm. */
    static final double STEPS_PER_METRE = 10_000;

    /** Parts of a quaternion are kept in steps of 1/20000. */
    static final double STEPS_PER_TURN = 20_000;

    /** Joint angles are kept in steps of 0.01 degrees. */
    static final double STEPS_PER_DEGREE = 100;

    /** Commanded speeds are kept in steps of 0.0001 rad/s. */
    static final double STEPS_PER_RADIAN = 10_000;

    /** Masses are kept in grams. */
    static final double STEPS_PER_KILOGRAM = 1000;

    /** Numbers of a place: three of the position, four of the rotation. */
    static final int NUMBERS_PER_POSE = 7;

    private RecordingFormat() {}
}
