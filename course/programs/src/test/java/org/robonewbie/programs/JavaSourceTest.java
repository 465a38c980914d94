package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.reflect.Field;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JavaSourceTest {

    @TempDir
    private Path folder;

    /** The program and the file beside it that the compiler finds by itself. */
    @ParameterizedTest
    @CsvSource({
        "UTF-8, '', '\n'",
        "UTF-8, '\uFEFF', '\r\n'",
        "UTF-16LE, '\uFEFF', '\r\n'",
        "UTF-16BE, '\uFEFF', '\n'",
        "windows-1252, '', '\r\n'",
        "windows-1252, '', '\r'"
    })
    void programAndItsNeighbourCompileAsAnyEditorSavesThem(String encoding, String mark, String end)
            throws ReflectiveOperationException, IOException {
        write("Main.java", encoding, mark, end, "public class Main {", "public static String text = Größe.TEXT; }");
        write("Größe.java", encoding, mark, end, "// grüße", "class Größe { static String TEXT = \"grüße\"; }");

        Field text =
                JavaSource.of(folder.resolve("Main.java")).load(List.of()).get().getField("text");

        assertThat(text.get(null)).isEqualTo("grüße");
    }

    @Test
    void neighbourInAPackageCompilesToo() throws ReflectiveOperationException, IOException {
        write(
                "de/uni/Main.java",
                "UTF-8",
                "\uFEFF",
                "\n",
                "package de.uni;",
                "public class Main extends de.tum.Mein {}");
        write("de/tum/Mein.java", "windows-1252", "", "\n", "package de.tum; public class Mein { public String ä; }");

        Class<?> main = JavaSource.of(folder.resolve("de/uni/Main.java"))
                .load(List.of())
                .get();

        assertThat(main.getField("ä")).isNotNull();
    }

    @Test
    void neighbourThatIsNoTextIsNamed() throws IOException {
        write("Main.java", "UTF-8", "", "\n", "public class Main { Tools tools; }");
        Files.write(folder.resolve("Tools.java"), new byte[] {'c', 0, (byte) 0x81});
        CompilerMessages messages = new CompilerMessages();

        assertThat(JavaSource.of(folder.resolve("Main.java")).compile(List.of(), messages))
                .isEmpty();

        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        messages.print(new PrintStream(printed, true, StandardCharsets.UTF_8));
        assertThat(printed.toString(StandardCharsets.UTF_8)).contains("Tools.java cannot be read: line 1 ");
    }

    @ParameterizedTest
    @CsvSource({"Main.java, cannot be read: line 1 ", "None.java, does not exist. Check the name."})
    void programThatCannotBeReadIsNamed(String name, String problem) throws IOException {
        Files.write(folder.resolve("Main.java"), new byte[] {'c', 0, (byte) 0x81});
        Path file = folder.resolve(name);

        assertThatThrownBy(() -> JavaSource.of(file))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("The file " + file + " " + problem);
    }

    @Test
    void classesAreWrittenOnlyWithoutMistakes() throws IOException {
        Path classes = folder.resolve("classes");
        JavaSource correct = JavaSource.of(folder.resolve("Main.java"), "class Main {}");
        JavaSource wrong = JavaSource.of(folder.resolve("Wrong.java"), "class Wrong {\n  int number = true;\n}");

        assertThat(correct.compile(List.of(), classes)).isTrue();
        assertThat(wrong.compile(List.of(), classes)).isFalse();
        assertThat(classes).isDirectoryContaining("glob:**Main.class").isDirectoryNotContaining("glob:**Wrong.class");
        assertThat(correct.check(List.of())).isEmpty();
        assertThat(wrong.check(List.of())).extracting(Remark::line).containsExactly(2);
    }

    @Test
    void expressionThatIsNestedTooDeeplyIsRefused() {
        String deep = "class Main { int number = " + "(".repeat(20_000) + "1" + ")".repeat(20_000) + "; }";
        JavaSource source = JavaSource.of(folder.resolve("Main.java"), deep);

        assertThatThrownBy(() -> source.compile(List.of(), folder))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("nested too deeply. Split it into several shorter ones.");
        assertThat(source.check(List.of()))
                .extracting(Remark::text)
                .singleElement()
                .asString()
                .contains("too deeply");
        assertThat(source.complete(List.of(), deep.length() - 3)).isEmpty();
    }

    @Test
    void fileWithoutItsClassIsRefused() {
        JavaSource source = JavaSource.of(folder.resolve("Main.java"), "class Other {}");

        assertThatThrownBy(() -> source.load(List.of()).get())
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("has no class Main. A file and its class must have the same name.");
    }

    @Test
    void messagesOfTheCompilerKeepTheirWords() throws IOException {
        write("Main.java", "UTF-8", "\uFEFF", "\n", "public class Main { int ä = }");
        CompilerMessages messages = new CompilerMessages();

        assertThat(JavaSource.of(folder.resolve("Main.java")).compile(List.of(), messages))
                .isEmpty();

        assertThat(messages.remarks())
                .singleElement()
                .satisfies(remark -> assertThat(remark.text()).isEqualTo("illegal start of expression"));
    }

    private void write(String name, String encoding, String mark, String end, String... lines) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.write(file, (mark + String.join(end, lines) + end).getBytes(Charset.forName(encoding)));
    }
}
