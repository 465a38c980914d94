package org.robonewbie.web.library.java.time;

import org.teavm.jso.JSBody;

/**
 * Converts times with the browser's functions. TeaVM does not process {@code JSBody} in {@link Instant}, because that
 * class is renamed.
 */
final class IsoTime {

    private IsoTime() {}

    /** Converts a time in ISO 8601 format to milliseconds since the epoch; returns NaN if the text is not a valid time. */
    @JSBody(params = "text", script = "return Date.parse(text);")
    static native double parse(String text);

    /** Converts milliseconds since the epoch to a time in ISO 8601 format. */
    @JSBody(params = "millis", script = "return new Date(millis).toISOString();")
    static native String format(double millis);
}
