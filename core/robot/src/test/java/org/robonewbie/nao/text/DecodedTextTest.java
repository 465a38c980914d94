package org.robonewbie.nao.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayOutputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DecodedTextTest {

    private static final String WRITTEN = "# Grüße\r\nRöt = „teams/red“ – 1 €\n";

    @ParameterizedTest
    @CsvSource({
        "UTF-8,,UTF_8",
        "UTF-8,EFBBBF,UTF_8",
        "UTF-16LE,FFFE,UTF_16_LE",
        "UTF-16BE,FEFF,UTF_16_BE",
        "windows-1252,,WINDOWS_1252"
    })
    void readsWhatEditorsWriteAndGivesTheSameBytesBack(String charset, String mark, TextEncoding encoding)
            throws UndecodableTextException {
        byte[] bytes = joined(mark, WRITTEN.getBytes(Charset.forName(charset)));

        DecodedText text = DecodedText.of(bytes);

        assertThat(text.content()).isEqualTo(WRITTEN);
        assertThat(text.encoding()).isEqualTo(encoding);
        assertThat(text.hasByteOrderMark()).isEqualTo(mark != null);
        assertThat(text.encode(text.content())).isEqualTo(bytes);
        assertThat(text.lines()).containsExactly("# Grüße", "Röt = „teams/red“ – 1 €");
    }

    @Property
    void isNeverDamagedByReadingAndSaving(@ForAll byte[] bytes) {
        try {
            DecodedText text = DecodedText.of(bytes);
            assertThat(text.encode(text.content())).isEqualTo(bytes);
        } catch (UndecodableTextException refused) {
            assertThat(refused.line()).isPositive();
        }
    }

    @Test
    void namesTheLineWhoseEncodingWasInferred() throws UndecodableTextException {
        byte[] bytes = "first\n  // grüße  \nüber".getBytes(StandardCharsets.ISO_8859_1);

        DecodedText text = DecodedText.of(bytes);

        assertThat(text.note())
                .hasValue(
                        "line 2 is not UTF-8 and was read as Windows-1252: \"// grüße\". " + DecodedText.SAVE_AS_UTF_8);
        assertThat(DecodedText.of("grüße".getBytes(StandardCharsets.UTF_8)).note())
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "610A62008163,2,neither UTF-8 nor Windows-1252",
        "FFFE000061000000,1,zero byte",
        "61000A006200,1,zero byte",
        "FFFE61000A0062,2,ends within a UTF-16 character",
        "FFFE0A0000D86100,2,ends within a UTF-16 character",
        "610D0A0A8163,3,neither UTF-8 nor Windows-1252",
        "01FF,1,neither UTF-8 nor Windows-1252",
        "EFBBBF0A61FC0A,2,damaged",
        "EFBBBFFCFCFC,1,damaged",
        "C3BC0AC3BCFF0A,2,damaged",
        "C3BCC3BCC3BC0AE282,2,damaged"
    })
    void refusesWhatIsNoTextAndNamesTheLine(String hexadecimal, int line, String problem) {
        byte[] bytes = HexFormat.of().parseHex(hexadecimal);

        assertThatExceptionOfType(UndecodableTextException.class)
                .isThrownBy(() -> DecodedText.of(bytes))
                .withMessageContaining("line " + line + " ")
                .withMessageContaining(problem)
                .withMessageEndingWith(DecodedText.SAVE_AS_UTF_8);
    }

    @Test
    void changesToUtf8IfALetterCannotBeSavedOtherwise() throws UndecodableTextException {
        DecodedText text = DecodedText.of("grüße".getBytes(StandardCharsets.ISO_8859_1));

        byte[] saved = text.encode(text.content() + " Привет");

        assertThat(new String(saved, StandardCharsets.UTF_8)).isEqualTo("grüße Привет");
    }

    @Test
    void takesQuotedWordsOfOldGermanFilesForWhatTheyAre() throws UndecodableTextException {
        byte[] bytes = "„Spaß“".getBytes(Charset.forName("windows-1252"));

        assertThat(DecodedText.of(bytes).content()).isEqualTo("„Spaß“");
    }

    private static byte[] joined(String mark, byte[] text) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.writeBytes(HexFormat.of().parseHex(mark == null ? "" : mark));
        bytes.writeBytes(text);
        return bytes.toByteArray();
    }
}
