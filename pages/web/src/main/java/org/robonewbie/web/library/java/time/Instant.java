package org.robonewbie.web.library.java.time;

/** Subset of {@link java.time.Instant} for the timestamps of students' progress, with millisecond precision. */
public final class Instant {

    private final long millis;

    private Instant(long millis) {
        this.millis = millis;
    }

    /** {@return the current time} */
    public static Instant now() {
        return new Instant(System.currentTimeMillis());
    }

    /**
     * Parses a time.
     *
     * @param text time in ISO 8601 format
     * @return the time
     */
    public static Instant parse(CharSequence text) {
        double millis = IsoTime.parse(text.toString());
        if (Double.isNaN(millis)) {
            throw new IllegalArgumentException("\"" + text + "\" is not a time.");
        }
        return new Instant((long) millis);
    }

    /** {@return the number of milliseconds since the epoch, 1970-01-01T00:00:00Z} */
    public long toEpochMilli() {
        return millis;
    }

    /** {@return the time in ISO 8601 format} */
    @Override
    public String toString() {
        return IsoTime.format(millis);
    }
}
