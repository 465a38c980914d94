package org.robonewbie.simulator.world;

/** The plates that feel the ground; the toes exist in robot type 4 only. */
public enum FootSensor {
    /** Under the right foot. */
    RIGHT_FOOT("rf", "rfoot"),
    /** Under the left foot. */
    LEFT_FOOT("lf", "lfoot"),
    /** Under the right toes. */
    RIGHT_TOES("rf1", "rtoe"),
    /** Under the left toes. */
    LEFT_TOES("lf1", "ltoe");

    private final String perceptorName;
    private final String linkName;

    FootSensor(String perceptorName, String linkName) {
        this.perceptorName = perceptorName;
        this.linkName = linkName;
    }

    /**
     * Names the sensor in SimSpark's messages.
     *
     * @return the perceptor name, such as {@code rf}
     */
    public String perceptorName() {
        return perceptorName;
    }

    /**
     * Names the link that carries the sensor.
     *
     * @return the link's name, such as {@code rfoot}
     */
    public String linkName() {
        return linkName;
    }
}
