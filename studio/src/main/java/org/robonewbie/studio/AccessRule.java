package org.robonewbie.studio;

import java.util.Optional;
import java.util.Set;
import org.robonewbie.studio.board.NewsBoard;

/**
 * Decides who may talk to the studio: only pages that this very server has delivered, opened under this computer's own name.
 *
 * <p>The host name is checked because a foreign site can point its own name at 127.0.0.1, the origin because any site may open
 * a WebSocket to this computer, and the token because other users of this computer can do so too.
 */
final class AccessRule {

    /** Where the live feed is. */
    static final String LIVE_PATH = "/live";

    /** Where files of the user's disk are read and written. */
    static final String WORK_PATH = "/api/";

    private final Set<String> hosts;
    private final AccessToken token;

    AccessRule(int port, AccessToken token) {
        this.hosts = Set.of("127.0.0.1:" + port, "localhost:" + port);
        this.token = token;
    }

    /**
     * Judges a request.
     *
     * @param method the HTTP method
     * @param host the Host header, empty if there is none
     * @param origin the Origin header, empty if there is none
     * @param path the path that is asked for
     * @param shownToken the token in the request, empty if there is none
     * @return why it is refused, or empty if it is welcome
     */
    Optional<String> refusal(String method, String host, String origin, String path, String shownToken) {
        if (!hosts.contains(host)) {
            return Optional.of(
                    "The studio answers to " + hosts.stream().sorted().toList() + " only, not to \"" + host
                            + "\". Open the address that the simulator has printed.");
        }
        if (!origin.isEmpty() && !origin.equals("http://" + host)) {
            return Optional.of("Pages of \"" + origin + "\" may not talk to the studio.");
        }
        if (path.equals(LIVE_PATH) || path.startsWith(NewsBoard.PATHS)) {
            return refusalOfLive(origin, shownToken);
        }
        if (path.startsWith(WORK_PATH)) {
            return refusalOfWork(method, origin, shownToken);
        }
        if (!method.equals("GET") && !method.equals("HEAD")) {
            return Optional.of("The studio's files can be read, but not changed with " + method + ".");
        }
        return Optional.empty();
    }

    private Optional<String> refusalOfLive(String origin, String shownToken) {
        if (origin.isEmpty()) {
            return Optional.of("Only a page of the studio may watch the simulation; this request names no origin.");
        }
        return refusalOfToken(shownToken);
    }

    private Optional<String> refusalOfWork(String method, String origin, String shownToken) {
        if (!method.equals("GET") && origin.isEmpty()) {
            return Optional.of("Only a page of the studio may change files; this request names no origin.");
        }
        return refusalOfToken(shownToken);
    }

    private Optional<String> refusalOfToken(String shownToken) {
        return token.matches(shownToken)
                ? Optional.empty()
                : Optional.of("The access token is missing or wrong. Open the address that the simulator has printed.");
    }
}
