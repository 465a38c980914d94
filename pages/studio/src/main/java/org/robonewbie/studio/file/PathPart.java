package org.robonewbie.studio.file;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;

/** Decoder for path segments of request addresses. */
public final class PathPart {

    private PathPart() {}

    /**
     * Decodes a path segment. A plus sign stays a plus sign, unlike in form data.
     *
     * @param part the percent-encoded segment
     * @return the decoded name
     * @throws IllegalArgumentException if the encoding is malformed
     */
    public static String decode(String part) {
        return URLDecoder.decode(part.replace("+", "%2B"), StandardCharsets.UTF_8);
    }
}
