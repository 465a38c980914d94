package org.robonewbie.nao.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class FileNameTest {

    static Stream<List<String>> names() {
        return Table.rows("file-names.tsv");
    }

    @ParameterizedTest
    @MethodSource("names")
    void saysWhatIsWrongWithAName(List<String> row) {
        assertThat(FileName.problem(row.get(0)).orElse("-")).isEqualTo(row.get(1));
    }

    @Property
    void goodNameIsOneFileInItsFolder(@ForAll String name) {
        if (FileName.problem(name).isEmpty()) {
            assertThat(name).isNotBlank().doesNotContain("/", "\\", "\0").doesNotStartWith(".");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"goal", "1st try", "größer", "球", "x²", "a_b-c", "123456789012345"})
    void plainNameHasOnlyLettersDigitsAndTheGivenSigns(String name) {
        assertThat(FileName.isPlain(name, " _-", 15)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " goal", "-goal", "a.b", "../out", "goal?", "CON", "goal ", "1234567890123456"})
    void otherNamesAreNotPlain(String name) {
        assertThat(FileName.isPlain(name, " _-", 15)).isFalse();
    }
}
