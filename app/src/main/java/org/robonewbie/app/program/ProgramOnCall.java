package org.robonewbie.app.program;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.robonewbie.agent.Agent;

/**
 * The process that runs a program of the studio: it is started before anybody knows which program that will be, and has loaded the
 * framework when it is told. So a changed program moves its robot at once.
 */
public final class ProgramOnCall {

    private static final String SEPARATOR = "\t";

    private final ExampleCatalogue examples;

    /**
     * Prepares the process.
     *
     * @param examples the examples, for messages
     */
    public ProgramOnCall(ExampleCatalogue examples) {
        this.examples = examples;
    }

    /** What the process is told. */
    static String call(String className, List<Path> classPath, List<String> options) {
        return className + SEPARATOR
                + String.join(
                        " ",
                        classPath.stream()
                                .map(place -> place.toUri().toString())
                                .toList())
                + SEPARATOR + String.join(SEPARATOR, options) + "\n";
    }

    /**
     * Waits for the name of a program, and runs it.
     *
     * @return its exit code; 0 if nobody called
     * @throws IOException if the call cannot be read
     */
    public int await() throws IOException {
        new Newcomer();
        BufferedReader calls = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        String call = calls.readLine();
        System.setIn(new ByteArrayInputStream(new byte[0]));
        if (call == null) {
            return 0;
        }
        List<String> words = Arrays.asList(call.split(SEPARATOR, -1));
        List<Path> classPath = Arrays.stream(words.get(1).split(" ", -1))
                .map(URI::create)
                .map(Path::of)
                .toList();
        return new AgentFinder(examples, classPath).ofClass(words.get(0)).run(words.subList(2, words.size()));
    }

    /** Makes Java load what each agent needs. */
    private static final class Newcomer extends Agent {}
}
