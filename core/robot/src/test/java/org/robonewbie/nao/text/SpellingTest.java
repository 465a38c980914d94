package org.robonewbie.nao.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SpellingTest {

    private static final List<String> WORDS = List.of("wave", "walk-forward", "look-around", "größe");

    @Test
    void findsTheWordThatWasMeant() {
        assertThat(Spelling.nearest("walk-foward", WORDS)).contains("walk-forward");
        assertThat(Spelling.nearest("Wvae", WORDS)).contains("wave");
    }

    @Test
    void proposesNothingThatIsFarAway() {
        assertThat(Spelling.nearest("somersault", WORDS)).isEmpty();
    }

    @Test
    void prefersWordsThatContainWhatWasWritten() {
        List<String> examples = List.of("Agent_Log", "Agent_Walk", "Agent_BasicStructure", "Agent_SimpleSoccer");

        assertThat(Spelling.nearest("Agent_Basic", examples)).contains("Agent_BasicStructure");
        assertThat(Spelling.nearest("simplesoccer", examples)).contains("Agent_SimpleSoccer");
    }

    @Test
    void withoutWordsThereIsNothingToPropose() {
        assertThat(Spelling.nearest("wave", List.of())).isEmpty();
        assertThat(Spelling.question("wave", List.of())).isEmpty();
    }

    @Test
    void wordIsNeverProposedForItself() {
        assertThat(Spelling.nearest("wave", WORDS)).isEmpty();
        assertThat(Spelling.nearest("look", List.of("look", "look-around"))).isEmpty();
    }

    @Test
    void asksInTheGivenForm() {
        assertThat(Spelling.question("wvae", WORDS, word -> "\"" + word + "\"")).isEqualTo(" Did you mean \"wave\"?");
        assertThat(Spelling.question("WAVE", WORDS)).isEqualTo(" Did you mean wave?");
        assertThat(Spelling.question("GRÖSSE", List.of("Größe", "grÖsse"))).isEqualTo(" Did you mean grÖsse?");
    }

    @ParameterizedTest
    @CsvSource({
        "\uFEFFwave, character 1 is an invisible byte order mark",
        "wave\u200B, character 5 is an invisible character (U+200B): delete it",
        "wa\u00ADve, character 3 is an invisible soft hyphen",
        "w\u0430ve, character 2 is the Cyrillic letter \u0430 (U+0430): type a",
        "WAV\u0415, character 4 is the Cyrillic letter \u0415 (U+0415): type E",
        "l\u03BFok-around, character 2 is the Greek letter \u03BF (U+03BF): type o",
        "walk\u2013forward, character 5 is the dash \u2013 (U+2013): type -",
        "gro\u0308ße, character 4 is a combining accent (U+0308)",
        "\uFF57ave, character 1 is the character \uFF57 (U+FF57): type w"
    })
    void characterThatCannotBeSeenIsNamed(String written, String difference) {
        assertThat(Spelling.question(written, WORDS))
                .startsWith(" It looks like ")
                .contains(", but " + difference);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"teams/red", "Красные", "Équipe d’été", "Jörg – Müller/programs", "文件夹", "Δt", "μ", "Ελλάς", "-5"
            })
    void lettersOfOtherLanguagesAreNotConfusable(String text) {
        assertThat(ConfusableCharacter.firstIn(text)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "Red\u00A0Team, 4",
        "teams/red\u200B, 10",
        "\u201CRed\u201D, 1",
        "seed \u22125, 6",
        "T\u0435am, 2",
        "😀\u2060x, 2",
        "Red\u2019, 4"
    })
    void firstConfusableCharacterIsCounted(String text, int number) {
        assertThat(ConfusableCharacter.firstIn(text).orElseThrow().number()).isEqualTo(number);
    }
}
