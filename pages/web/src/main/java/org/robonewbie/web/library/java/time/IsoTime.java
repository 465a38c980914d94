package org.robonewbie.web.library.java.time;

import org.teavm.jso.JSBody;

/**
 * Converts times with the browser's functions. TeaVM does not process {@code JSBody} in {@link Instant}, because that
 * class is renamed.
 */
final class IsoTime {

    private IsoTime() {}

    /** Returns the milliseconds since 1970 of a time in ISO 8601, or NaN if the text is not a valid time. */
    @JSBody(params = "text", script = "return Date.parse(text);")
    static native double parse(String text);

    /** Formats the milliseconds since 1970 in ISO 8601. */
    @JSBody(params = "millis", script = "return new Date(millis).toISOString();")
    static native String format(double millis);
}
