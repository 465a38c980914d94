package org.robonewbie.studio;

import java.util.Optional;
import java.util.Set;
import org.robonewbie.studio.board.EventBus;

/**
 * Decides who may talk to the studio: only pages that this very server has delivered, opened under this computer's own name.
 *
 * <p>The host name is checked because a foreign site can point its own name at 127.0.0.1, the origin because any site may open
 * a WebSocket to this computer, and the cookie because other users of this computer can do so too.
 */
final class AccessRule {

    /** Where the live feed is. */
    static final String LIVE_PATH = "/live";

    /** Where files of the user's disk are read and written. */
    static final String WORK_PATH = "/api/";

    private static final Set<String> FOREIGN_SITES = Set.of("cross-site", "same-site");

    private final Set<String> hosts;

    AccessRule(int port) {
        this.hosts = Set.of("127.0.0.1:" + port, "localhost:" + port);
    }

    /**
     * Judges a request.
     *
     * @param method the HTTP method
     * @param host the Host header, empty if there is none
     * @param origin the Origin header, empty if there is none
     * @param site the Sec-Fetch-Site header: from where a browser says that it comes, empty if there is none
     * @param path the path that is asked for
     * @param isSignedIn whether the request shows the studio's cookie
     * @return why it is refused, or empty if it is welcome
     */
    Optional<String> refusal(String method, String host, String origin, String site, String path, boolean isSignedIn) {
        if (!hosts.contains(host)) {
            return Optional.of(
                    "The studio answers to " + hosts.stream().sorted().toList() + " only, not to \"" + host
                            + "\". Open the address that the simulator has printed.");
        }
        if (!origin.isEmpty() && !origin.equals("http://" + host)) {
            return Optional.of("Pages of \"" + origin + "\" may not talk to the studio.");
        }
        boolean isLive = path.equals(LIVE_PATH) || path.startsWith(EventBus.PATHS);
        if (isLive || path.startsWith(WORK_PATH)) {
            return refusalOfUse(isLive, method, origin, site, isSignedIn);
        }
        if (!method.equals("GET") && !method.equals("HEAD")) {
            return Optional.of("The studio's files can be read, but not changed with " + method + ".");
        }
        return Optional.empty();
    }

    /** A page at another port of this computer shows the cookie too; the browser says that it is another page. */
    private static Optional<String> refusalOfUse(
            boolean isLive, String method, String origin, String site, boolean isSignedIn) {
        if (FOREIGN_SITES.contains(site)) {
            return Optional.of("Pages of other addresses may not talk to the studio.");
        }
        if (isLive && origin.isEmpty()) {
            return Optional.of("Only a page of the studio may watch the simulation; this request names no origin.");
        }
        if (!method.equals("GET") && origin.isEmpty()) {
            return Optional.of("Only a page of the studio may change files; this request names no origin.");
        }
        return isSignedIn
                ? Optional.empty()
                : Optional.of(
                        "This browser has not been let in yet, or the studio was started by another user. Press Enter in"
                                + " the terminal where RoboNewbie runs and open the address that it prints.");
    }
}
