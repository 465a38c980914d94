package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is said to beginners beside the compiler's words, each for a program that makes the compiler say it. */
class BeginnersHintsTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "int a = 1                        | Something is missing just before this point",
                "String s = 'hello';              | Write strings between",
                "String s = \"hello;              | needs a \" at its end",
                "int a = \"x\";                   | does not fit here",
                "if (1 = 2) {}                    | Compare",
                "int a; a = a + 1;                | Give the variable a value where it is declared",
                "int a = 1; int a = 2;            | This name is already in use",
                "return 1;                        | A value of this type does not fit here",
                "while (true) {} int a = 1;       | The program never reaches this line",
                "Thread.currentThread().join(9);  | Surround the call with try",
                "5;                               | does nothing with it",
                "else { }                         | must follow directly after",
                "final int a = 1; a = 2;          | final",
                "String s = \"a\" - 1;            | Check both sides",
                "Math.max(1);                     | Compare the number, order and types",
                "wobbleQuux = 1;                  | Java does not recognise this name here",
            })
    void mistakeSaysWhatToDo(String line, String hint) {
        String text = "class A {\n    void think() {\n        " + line.strip() + "\n    }\n}\n";

        List<Remark> remarks = JavaSource.of(Path.of("A.java"), text).check(List.of());

        assertThat(remarks).isNotEmpty();
        assertThat(remarks.get(0).hint()).as(remarks.get(0).text()).contains(hint);
    }
}
