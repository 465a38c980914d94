package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.embedded.Viewer;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** The studio serves the documentation that was built with it. */
class ServedDocumentationTest {

    @Test
    void studioServesPagesAndPictures() throws Exception {
        assumeTrue(
                Main.class.getResource("/org/robonewbie/site/pages/index.html") != null,
                "The pages are made by Maven; this run has none.");
        SimulatorSettings settings = SimulatorSettings.of(
                        WorldSettings.beginner().withSynchronous(false))
                .withAgentPort(0)
                .withAwaitedAgents(1);

        try (Simulator simulator = Simulator.start(settings, Console.silent());
                Viewer.View studio = ServiceLoader.load(Viewer.class)
                        .findFirst()
                        .orElseThrow()
                        .open(simulator.control(), 0)) {
            HttpResponse<String> page = get(studio.address(), "/docs/");
            HttpResponse<String> lesson = get(studio.address(), "/docs/tutorial/1-perception.html");
            HttpResponse<String> picture = get(studio.address(), "/docs/images/studio-field.png");
            HttpResponse<String> missing = get(studio.address(), "/docs/nothing.html");

            assertThat(page.statusCode()).isEqualTo(200);
            assertThat(page.body()).contains("Installation", "Quick start tutorial");
            assertThat(lesson.body()).contains("Observer.java");
            assertThat(picture.headers().firstValue("Content-Type")).contains("image/png");
            assertThat(missing.statusCode()).isEqualTo(404);
        }
    }

    private static HttpResponse<String> get(URI studio, String path) throws Exception {
        HttpClient client =
                HttpClient.newBuilder().proxy(HttpClient.Builder.NO_PROXY).build();
        HttpRequest request = HttpRequest.newBuilder(studio.resolve(path)).build();
        return client.send(request, HttpResponse.BodyHandlers.ofString());
    }
}
