package org.robonewbie.simulator.world;

/** The plates that feel the ground; the toes exist in robot type 4 only. */
enum FootSensor {
    LEFT_FOOT("lfoot"),
    RIGHT_FOOT("rfoot"),
    LEFT_TOE("ltoe"),
    RIGHT_TOE("rtoe");

    private final String linkName;

    FootSensor(String linkName) {
        this.linkName = linkName;
    }

    String linkName() {
        return linkName;
    }
}
