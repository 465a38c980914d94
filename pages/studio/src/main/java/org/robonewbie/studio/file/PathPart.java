package org.robonewbie.studio.file;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;

/** Names of files in the addresses that pages ask for. */
public final class PathPart {

    private PathPart() {}

    /**
     * Decodes a part of an address's path, in which a plus sign is no blank, other than in forms.
     *
     * @param part the part, with per cent signs before the codes of other characters
     * @return the name that it stands for
     * @throws IllegalArgumentException if it is damaged
     */
    public static String decode(String part) {
        return URLDecoder.decode(part.replace("+", "%2B"), StandardCharsets.UTF_8);
    }
}
