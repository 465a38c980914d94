package org.robonewbie.app.doctor;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.ServiceLoader;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** Starts the studio and fetches its start page. */
final class StudioCheck {

    private static final String SUBJECT = "Studio";
    private static final Duration TIMEOUT = Duration.ofSeconds(5);
    private static final int OK = 200;

    private StudioCheck() {}

    static Finding page() {
        SimulatorSettings settings = SimulatorSettings.of(
                        WorldSettings.beginner().withSynchronous(false))
                .withAgentPort(0)
                .withAwaitedAgents(1);
        try (Simulator simulator = Simulator.start(settings, Console.silent());
                Viewer.View view = ServiceLoader.load(Viewer.class)
                        .findFirst()
                        .orElseThrow()
                        .open(simulator.control(), 0)) {
            return fetch(view.address());
        } catch (IOException | RuntimeException failed) {
            return Finding.broken(
                    SUBJECT,
                    failed.toString(),
                    "Does a firewall block servers on 127.0.0.1? Use --headless to work without the studio.");
        }
    }

    private static Finding fetch(URI address) throws IOException {
        HttpClient client = HttpClient.newBuilder()
                .proxy(HttpClient.Builder.NO_PROXY)
                .connectTimeout(TIMEOUT)
                .build();
        HttpRequest request = HttpRequest.newBuilder(address).timeout(TIMEOUT).build();
        try {
            int status =
                    client.send(request, HttpResponse.BodyHandlers.discarding()).statusCode();
            return status == OK
                    ? Finding.well(SUBJECT, "its page is served on this computer")
                    : Finding.broken(SUBJECT, "its page answers " + status, "Please report this.");
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return Finding.notable(SUBJECT, "not checked", "The check was interrupted.");
        }
    }
}
