package org.robonewbie.programs.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class WorkerPoolTest {

    @TempDir
    private Path folder;

    private WorkerPool pool;

    @BeforeEach
    void createPool() throws IOException {
        Path file = Files.writeString(folder.resolve("Repeats.java"), """
                public class Repeats {
                    private static int runs;

                    public static void main(String[] args) {
                        runs++;
                        if (args[0].equals("fail")) {
                            throw new IllegalStateException("run " + runs);
                        } else if (args[0].equals("exit")) {
                            System.err.println("enough after run " + runs);
                            System.exit(Integer.parseInt(args[1]));
                        }
                    }
                }
                """);
        pool = new WorkerPool(file.toString(), List.of(folder));
    }

    @AfterEach
    void close() {
        pool.close();
    }

    @Tag("slow")
    @Test
    void eachRunHasFreshStaticFieldsAndItsOwnFailure() throws IOException {
        String failure = "The program failed. It said: Repeats ended with java.lang.IllegalStateException: run 1"
                + " (Repeats.java:7)";

        assertThat(run("succeed")).contains("");
        assertThat(run("fail")).contains(failure);
        assertThat(run("fail")).contains(failure);
        assertThat(run("succeed")).contains("");
    }

    @Test
    void endOfAProcessCostsOneRun() throws IOException {
        assertThat(run("exit", "0")).contains("The program ended its process. It said: enough after run 1");
        assertThat(run("succeed")).contains("");
    }

    @Tag("slow")
    @Test
    void interruptionByTheUserIsNoFailure() throws IOException {
        assertThat(run("exit", "130")).isEmpty();
    }

    private Optional<String> run(String... options) throws IOException {
        return pool.run(List.of(options));
    }
}
