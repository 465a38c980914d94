package org.robonewbie.studio.file;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

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

    /**
     * Decodes the segments of a path.
     *
     * @param path percent-encoded segments, separated by slashes
     * @return the decoded names; empty segments are omitted
     * @throws IllegalArgumentException if the encoding is malformed
     */
    public static List<String> decodeAll(String path) {
        return Arrays.stream(path.split("/", -1))
                .filter(name -> !name.isEmpty())
                .map(PathPart::decode)
                .toList();
    }
}
