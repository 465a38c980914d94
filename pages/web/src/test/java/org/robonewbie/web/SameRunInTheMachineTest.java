package org.robonewbie.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.simulator.recording.RunReport;
import org.robonewbie.pagejvm.JavaSource;
import org.robonewbie.pagejvm.MemoryLoader;
import org.robonewbie.pagejvm.Program;

/** Programs behave in the page's interpreter as in Java: their recordings are identical bit for bit. */
class SameRunInTheMachineTest {

    private static final List<String> OTHERWISE = List.of(
            "Agent_TwoBehaviours", // needs threads
            "Agent_KeyframeDeveloper", // needs files
            "Agent_PenaltyAttacker", // extends another example
            "Agent_TestSelfLocalisation", // needs ground truth
            "Agent_TestLocalFieldView", // the same
            "Agent_SoccerTeam"); // several robots
    private static final int SECONDS = 12;

    @TempDir
    private Path folder;

    static Stream<KnownPrograms.Text> programs() {
        return Stream.concat(KnownPrograms.examples().stream(), KnownPrograms.documented().stream())
                .filter(program -> !OTHERWISE.contains(program.name()));
    }

    @ParameterizedTest
    @MethodSource("programs")
    void programHasTheSameRecordingInTheMachineAndInJava(KnownPrograms.Text text) throws Exception {
        Map<String, byte[]> classes = JavaSource.compile(text.name(), text.text());

        RunReport here = HeadlessRun.of(
                new Program(classes.values()), new PrintStream(OutputStream.nullOutputStream()), 1, SECONDS);

        assertThat(here.recordingSha256()).isEqualTo(recordingInJava(text.name(), classes));
    }

    /** Runs the main method as the command line does. */
    private String recordingInJava(String name, Map<String, byte[]> classes) throws Exception {
        Path report = folder.resolve("report.json");
        Class<?> type = new MemoryLoader(classes)
                .loadClass(classes.keySet().stream()
                        .filter(one -> one.endsWith(name))
                        .findFirst()
                        .orElseThrow());
        Method main = type.getMethod("main", String[].class);
        main.invoke(null, (Object) new String[] {
            "--headless", "--fast", "--seed", "1", "--seconds", "" + SECONDS, "--report", report.toString()
        });
        return JsonParser.parseString(Files.readString(report))
                .getAsJsonObject()
                .get("recordingSha256")
                .getAsString();
    }
}
