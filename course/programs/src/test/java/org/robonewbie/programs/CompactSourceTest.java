package org.robonewbie.programs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CompactSourceTest {

    @ParameterizedTest
    @ValueSource(
            strings = {
                "void main() { IO.println(1); }",
                "import java.util.List;\nint x = 3;\nvoid main(String[] args) { }",
                "static void main() { }\nclass Other { }",
                "/* class Kick { */ void main() { String brace = \"{\"; char other = '{'; }",
                "record Point(int x) { }\n\npublic void main ( ) { // class Kick\n}"
            })
    void mainWithoutAClassNeedsJava25(String text) {
        assertThat(CompactSource.trouble(text, "Kick", 21))
                .hasValueSatisfying(sentence -> assertThat(sentence)
                        .startsWith(
                                "A file whose main method is outside a class needs Java 25 or newer, but this is Java 21.")
                        .contains("public class Kick"));
        assertThat(CompactSource.trouble(text, "Kick", 25)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "public class Kick { public static void main(String[] args) { } }",
                "class Kick { void think() { } } }\n void main() { }",
                "class Kick { void main() { }",
                "class Other { void main() { } }",
                "// void main() { }",
                "import java.util.List;",
                ""
            })
    void mistakesInOrdinaryFilesAreLeftToTheCompiler(String text) {
        assertThat(CompactSource.trouble(text, "Kick", 17)).isEmpty();
    }

    @Test
    void deepNestingEnds() {
        assertThat(CompactSource.trouble("{".repeat(500) + "void main(){}" + "}".repeat(500), "Kick", 17))
                .isEmpty();
    }
}
