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
     * Returns no properties, because a page has no files.
     *
     * @param file ignored
     * @return an empty map
     */
    public static Map<String, String> properties(String file) {
        return Map.of();
    }
}
