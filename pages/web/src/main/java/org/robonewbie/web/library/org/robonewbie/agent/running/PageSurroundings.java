package org.robonewbie.web.library.org.robonewbie.agent.running;

import java.util.Map;

/** Empty environment: a page has neither environment variables nor properties files. */
public final class PageSurroundings {

    private PageSurroundings() {}

    /** {@return an empty map} */
    public static Map<String, String> environment() {
        return Map.of();
    }

    /**
     * Reads no file.
     *
     * @param file name of the file
     * @return an empty map
     */
    public static Map<String, String> properties(String file) {
        return Map.of();
    }
}
