package org.robonewbie.app.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.studio.program.RunningProgram;

class ProcessCompilerServiceTest {

    private static final String PROGRAM = """
            public class Lat extends org.robonewbie.agent.Agent {
                String größe = "ß";
                protected void think() {}
                public static void main(String[] args) { new Lat().run(args); }
            }
            """;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"UTF-8,''", "UTF-8,EFBBBF", "windows-1252,''", "UTF-16LE,FFFE"})
    void savedProgramIsCompiledInItsEncoding(String charset, String mark) throws IOException {
        byte[] text = PROGRAM.getBytes(Charset.forName(charset));
        Path file = Files.write(
                folder.resolve("Lat.java"),
                HexFormat.of().parseHex(mark + HexFormat.of().formatHex(text)));
        AtomicBoolean isCompiled = new AtomicBoolean();

        try (ProcessCompilerService compiler = new ProcessCompilerService(folder)) {
            Optional<RunningProgram> running = compiler.start(file, 1, () -> isCompiled.set(true));
            running.ifPresent(RunningProgram::close);
        }

        assertThat(isCompiled).isTrue();
    }

    @Test
    void programThatCannotBeDecodedIsRefusedWithItsLine() throws IOException {
        Path file = Files.write(folder.resolve("Odd.java"), new byte[] {'a', '\n', (byte) 0x81});

        try (ProcessCompilerService compiler = new ProcessCompilerService(folder)) {
            assertThatExceptionOfType(UnreadableFileException.class)
                    .isThrownBy(() -> compiler.start(file, 1, () -> {}))
                    .withMessageContaining("Odd.java cannot be read: line 2 is neither UTF-8 nor Windows-1252");
        }
    }
}
