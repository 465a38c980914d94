package org.robonewbie.studio.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class PageRequestTest {

    private static final Path SCRIPT = Path.of("src/main/resources/org/robonewbie/studio/web/live/page-request.js");

    /** The type that the scripts of studio and web edition are checked against; {@code -Dtables=write} writes it. */
    @Test
    void scriptsHaveTheSameList() throws IOException {
        String requests = Arrays.stream(PageRequest.values())
                .map(each -> "'" + each + "'")
                .collect(Collectors.joining("\n *   | "));
        String script = """
                /** Requests to the studio's server: those of the Java enum PageRequest, whose test writes this file. */

                /**
                 * @typedef {%s} PageRequest
                 */
                export {};
                """.formatted(requests);
        if (System.getProperty("tables", "").equals("write")) {
            Files.writeString(SCRIPT, script);
        }

        assertThat(SCRIPT).hasContent(script);
    }

    @ParameterizedTest
    @EnumSource(PageRequest.class)
    void eachRequestIsTheFirstThatFitsIt(PageRequest request) {
        String text = request.toString();
        int space = text.indexOf(' ');

        assertThat(fitting(text.substring(0, space), text.substring(space + 1))).isEqualTo(request);
    }

    @ParameterizedTest
    @CsvSource({
        "GET, files/program/src/main/java/my/Kick.java, READ_FILE",
        "POST, programs/check/src/main/java/my/Kick.java, CHECK_PROGRAM",
        "GET, course/attempt, ATTEMPT",
        "POST, course/kick, BEGIN_ATTEMPT",
        "PUT, recordings/run, RENAME_RECORDING",
    })
    void namesMayBeAnything(String method, String path, PageRequest expected) {
        assertThat(fitting(method, path)).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource({"GET, nothing", "POST, files/program/Kick.java", "GET, recordings/a/b", "GET, index", "PATCH, robot"})
    void othersFitNone(String method, String path) {
        assertThat(requests(method, path)).isEmpty();
    }

    private static PageRequest fitting(String method, String path) {
        return requests(method, path).findFirst().orElseThrow();
    }

    private static Stream<PageRequest> requests(String method, String path) {
        List<String> segments = List.of(path.split("/", -1));
        return Arrays.stream(PageRequest.values()).filter(each -> each.fits(method, segments));
    }
}
