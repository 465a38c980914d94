package org.robonewbie.simulator.recording;

import java.util.HashMap;
import java.util.Map;
import org.robonewbie.nao.model.RobotType;

/** Constants of the recording format; see {@code docs/recording-format.md}. */
final class RecordingFormat {

    static final String MAGIC = "RoboNewbie recording\n";
    static final int VERSION = 1;

    static final int HEADER = 1;
    static final int GAME = 2;
    static final int ROBOTS = 3;
    static final int COMMANDS = 4;
    static final int EVENT = 5;
    static final int CYCLE = 6;

    /** State record at the start of an excerpt that is sent to a browser page; never used in a file. */
    static final int STATE = 7;

    /** Kind of record that lists all objects on the pitch; absent in a soccer match. */
    static final int THINGS = 8;

    /** Kind of record that contains the new pose of one object. */
    static final int MOVED_THING = 9;

    /** Kind of record that defines a robot type beyond the NAOs; absent if all robots are NAOs. */
    static final int MODEL = 10;

    /** Number of robot types that need no record of kind {@link #MODEL}. */
    static final int NAO_TYPES = RobotType.values().length;

    /** Resolution of positions: 0.1 mm. */
    static final double STEPS_PER_METRE = 10_000;

    /** Resolution of quaternion components: 1/20000. */
    static final double STEPS_PER_TURN = 20_000;

    /** Resolution of joint angles: 0.01 degrees. */
    static final double STEPS_PER_DEGREE = 100;

    /** Resolution of commanded speeds: 0.0001 rad/s. */
    static final double STEPS_PER_RADIAN = 10_000;

    /** Resolution of masses: 1 g. */
    static final double STEPS_PER_KILOGRAM = 1000;

    static final int MAX_RECORD_BYTES = 1 << 24;

    /** Number of values of a pose: position and quaternion. */
    static final int NUMBERS_PER_POSE = 7;

    private RecordingFormat() {}

    /** Reads the {@code name=value} lines of a header record. */
    static Map<String, String> readHeader(RecordCursor content) {
        Map<String, String> header = new HashMap<>();
        for (String line : content.getText().split("\n", -1)) {
            int equals = line.indexOf('=');
            if (equals > 0) {
                header.put(line.substring(0, equals), line.substring(equals + 1));
            }
        }
        return header;
    }
}
