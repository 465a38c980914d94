package org.robonewbie.web.library.org.robonewbie.agent.running;

import java.util.Map;

/** A page has no environment and no files of properties. */
public final class PageSurroundings {

    private PageSurroundings() {}

    /** {@return nothing} */
    public static Map<String, String> environment() {
        return Map.of();
    }

    /**
     * Reads no file.
     *
     * @param file its name
     * @return nothing
     */
    public static Map<String, String> properties(String file) {
        return Map.of();
    }
}
