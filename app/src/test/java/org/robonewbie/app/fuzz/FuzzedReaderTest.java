package org.robonewbie.app.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.app.Project;

/** All inputs that fuzzing has collected and found, once each. */
class FuzzedReaderTest {

    private static final Path CORPUS = Project.ROOT.resolve("app/src/test/resources/org/robonewbie/app/fuzz");

    @ParameterizedTest
    @EnumSource(FuzzedReader.class)
    void readerUnderstandsOrRefusesWhateverItWasFed(FuzzedReader reader) throws IOException {
        List<Path> inputs;
        try (Stream<Path> files = Files.list(CORPUS.resolve(reader.label()))) {
            inputs = files.sorted().toList();
        }

        assertThat(inputs).hasSizeGreaterThan(1);
        for (Path input : inputs) {
            byte[] bytes = Files.readAllBytes(input);
            assertThatCode(() -> reader.read(bytes)).as(input.toString()).doesNotThrowAnyException();
        }
    }
}
