package org.robonewbie.app.studio;

import picocli.CommandLine.Option;

/** Command-line options for the display of a search. */
public final class SearchStudioOptions {

    @Option(names = "--headless", description = "Do not open a page; the program exits when the search ends.")
    boolean isHeadless;

    @Option(names = "--no-browser", description = "Print the address of the page instead of opening a browser.")
    boolean isWithoutBrowser;

    @Option(names = "--port", paramLabel = "N", description = "Port for the page (default: 3400, or any free one).")
    int port;

    /** Creates the default options. */
    public SearchStudioOptions() {}

    /** {@return whether the search runs without a page} */
    public boolean isHeadless() {
        return isHeadless;
    }
}
