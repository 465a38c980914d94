package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Scripts read text that people wrote by {@code state/decoded-text.js} only, which loses no letter and names what it cannot read. */
class ScriptReadersTest {

    private static final Pattern READER = Pattern.compile(
            "(\\)|answer|blob|file|response)\\s*\\.text\\(\\)|TextDecoder\\(|readAsText|readAsBinaryString|TextDecoderStream");

    private static final List<Path> FOLDERS =
            List.of(Path.of("src/main/resources/org/robonewbie/studio/web"), Path.of("../web/src/main/page"));

    /** Places that read what programs wrote: how many there are in each script, and what they read. */
    private static final Map<String, Integer> EXCEPTIONS = new TreeMap<>(Map.ofEntries(
            Map.entry("state/decoded-text.js", 2), // the reader; the other one shows what it refused
            Map.entry(
                    "state/replay/recording-source.js", 1), // names in recordings, which the simulator writes in UTF-8
            Map.entry("replay/recording-api.js", 2), // a refusal of the server; notes of a run, which the studio writes
            Map.entry("replay/standalone.js", 1), // the page's own scripts
            Map.entry("program/program-service.js", 2), // a program that the studio made; a refusal of the server
            Map.entry("motion/motion-files.js", 1), // a refusal of the server
            Map.entry("live/connection.js", 1), // a refusal of the server
            Map.entry("panels/course-panel.js", 1), // a refusal of the server
            Map.entry("panels/scene-panel.js", 1), // a refusal of the server
            Map.entry("page/course-solutions.js", 1), // solutions that come with the page
            Map.entry("page/motion-server.js", 1), // the index of the library
            Map.entry("page/program-server.js", 1), // examples that come with the page
            Map.entry("page/page-compiler.js", 1), // the names of classes that the build has found missing
            Map.entry("page/share.js", 1))); // a program that the page has packed into an address

    @Test
    void onlyOneModuleReadsTextOfPeople() throws IOException {
        Map<String, Integer> found = new TreeMap<>();
        for (Path folder : FOLDERS) {
            try (Stream<Path> scripts = Files.walk(folder)) {
                for (Path script : scripts.filter(ScriptReadersTest::isOurs).toList()) {
                    int readers = (int)
                            READER.matcher(Files.readString(script)).results().count();
                    if (readers > 0) {
                        found.put(folder.relativize(script).toString().replace('\\', '/'), readers);
                    }
                }
            }
        }

        assertThat(found).isEqualTo(EXCEPTIONS);
    }

    private static boolean isOurs(Path script) {
        return script.toString().endsWith(".js") && !script.toString().contains("vendor");
    }
}
