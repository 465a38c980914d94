package org.robonewbie.protocol.effector;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;
import org.robonewbie.protocol.effector.EffectorCommand.RequestPass;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorCommand.Synchronise;
import org.robonewbie.protocol.frame.MessageBuffer;

class EffectorMessageReaderTest {

    private final EffectorMessageReader reader = new EffectorMessageReader();
    private final List<EffectorCommand> commands = new ArrayList<>();
    private final List<String> problems = new ArrayList<>();

    @Test
    void readsTheDialogueOfATypicalAgent() {
        read("(scene rsg/agent/nao/nao.rsg)(syn)");
        read("(init (unum 3)(teamname Stars))(syn)");
        read("(beam -1 0.5 90)(syn)");
        read("(he1 0.5)(lle4 -1.25)(say hello)(pass)(syn)");

        assertThat(commands)
                .containsExactly(
                        new CreateRobot("rsg/agent/nao/nao.rsg", List.of()),
                        new Synchronise(),
                        new JoinTeam(3, "Stars"),
                        new Synchronise(),
                        new Beam(new Pose2d(-1, 0.5, 90)),
                        new Synchronise(),
                        new SetHingeSpeed("he1", 0.5),
                        new SetHingeSpeed("lle4", -1.25),
                        new Say("hello"),
                        new RequestPass(),
                        new Synchronise());
        assertThat(problems).isEmpty();
    }

    @Test
    void readsTheRobotType() {
        read("(scene rsg/agent/nao/nao_hetero.rsg 4)");

        assertThat(commands).containsExactly(new CreateRobot("rsg/agent/nao/nao_hetero.rsg", List.of("4")));
    }

    @Test
    void readsToes() {
        read("(lle7 1)(rle7 -1)");

        assertThat(commands).containsExactly(new SetHingeSpeed("lle7", 1), new SetHingeSpeed("rle7", -1));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "(init (unum 1)(teamname A)) | 1 | A",
                "(init (teamname A) (unum 1)) | 1 | A",
                "(init (teamname A)) | 0 | A",
                "(init (unum 7)) | 7 | ''",
                "(init) | 0 | ''",
                "(init (unum 2.9) (teamname) (colour red)) | 2 | ''"
            })
    void takesThePartsOfInitInAnyOrder(String text, int number, String team) {
        read(text);

        assertThat(commands).containsExactly(new JoinTeam(number, team));
    }

    @ParameterizedTest
    @CsvSource({"1.2E-3, 0.0012", "+2, 2", "abc, 0", "1e308, 1e308", "nan, NaN", "-inf, -Infinity", "3x, 3"})
    void readsNumbersAsTheCLibraryDoes(String text, Double expected) {
        read("(he1 " + text + ")");

        assertThat(commands).containsExactly(new SetHingeSpeed("he1", expected));
    }

    @Test
    void dropsACommandThatIsNotFinished() {
        read("(he1 1)(he2 2");

        assertThat(commands).containsExactly(new SetHingeSpeed("he1", 1));
    }

    @Test
    void losesTheRestAfterASurplusParenthesis() {
        read("(he1 1))(he2 2)");

        assertThat(commands).containsExactly(new SetHingeSpeed("he1", 1));
    }

    @Test
    void skipsWordsOutsideOfLists() {
        read("he1 1 (he2 2) ) ");

        assertThat(commands).containsExactly(new SetHingeSpeed("he2", 2));
    }

    @Test
    void readsCommandsOverSeveralLinesWithComments() {
        read("(he1 1) ; look left\r\n(he2\n2)");

        assertThat(commands).containsExactly(new SetHingeSpeed("he1", 1), new SetHingeSpeed("he2", 2));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "(fly 1) | Unknown effector \"fly\" was ignored",
                "(he1) | Joint command \"he1\" was ignored: it needs one number, the speed in radians per second",
                "(he1 (2)) | Joint command \"he1\" was ignored: it needs one number, the speed in radians per second",
                "(beam 1 2) | \"beam\" was ignored: it needs three numbers, x and y in metres and the heading in degrees",
                "(say) | \"say\" was ignored: it needs a text of 1 to 20 characters without spaces or parentheses",
                "(scene) | \"scene\" was ignored: it needs a file name such as rsg/agent/nao/nao.rsg",
            })
    void saysWhatItIgnored(String text, String problem) {
        read(text + "(syn)");

        assertThat(problems).containsExactly(problem);
        assertThat(commands).containsExactly(new Synchronise());
    }

    @ParameterizedTest
    @CsvSource({
        "(say a b c),a",
        "(say a(b)c),a",
        "(say\ta\tb),a",
        "(say pass 123456789012345678901),pass",
        "(say a ()),a"
    })
    void takesTheFirstWordOfATextAsTheOriginalDoes(String text, String heard) {
        read(text + "(syn)");

        assertThat(commands).containsExactly(new Say(heard), new Synchronise());
        assertThat(problems).isEmpty();
    }

    @Test
    void dropsATextThatIsNotClosed() {
        read("(say a b");

        assertThat(commands).isEmpty();
    }

    @Test
    void dropsTextsThatAreTooLong() {
        read("(say 123456789012345678901)(say 12345678901234567890)");

        assertThat(commands).containsExactly(new Say("12345678901234567890"));
        assertThat(problems)
                .hasSize(1)
                .first()
                .asString()
                .contains("at most 20 characters")
                .contains("has 21");
    }

    @ParameterizedTest
    @ValueSource(strings = {"gr\u00fc\u00df", "a\u0007b", "\u007f"})
    void dropsTextsWithCharactersThatARobotCannotSay(String text) {
        read("(say " + text + ")");

        assertThat(commands).isEmpty();
        assertThat(problems).hasSize(1).first().asString().contains("because of the character");
    }

    @Test
    void complainsAtMostElevenTimesPerMessage() {
        read("(fly)".repeat(1000));

        assertThat(problems).hasSize(11).last().isEqualTo("990 more commands of this message were ignored");
    }

    @Test
    void showsOnlyTheBeginningOfALongName() {
        read("(" + "x".repeat(100_000) + ")");

        assertThat(problems).containsExactly("Unknown effector \"" + "x".repeat(60) + "…\" was ignored");
    }

    @Test
    void showsNoControlCharacters() {
        read("(\u001b[31m)");

        assertThat(problems).containsExactly("Unknown effector \"(unprintable)\" was ignored");
    }

    @Test
    void bearsDeepNesting() {
        read("(".repeat(100_000) + "he1 1" + ")".repeat(100_000) + "(he2 2)");

        assertThat(commands).containsExactly(new SetHingeSpeed("he2", 2));
    }

    @Property
    void bearsAnyBytes(@ForAll byte[] bytes) {
        MessageBuffer message = new MessageBuffer();
        message.resize(bytes.length);
        System.arraycopy(bytes, 0, message.bytes(), 0, bytes.length);

        reader.read(message, commands::add, problems::add);

        assertThat(commands).hasSizeLessThanOrEqualTo(bytes.length);
    }

    private void read(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        MessageBuffer message = new MessageBuffer();
        message.resize(bytes.length);
        System.arraycopy(bytes, 0, message.bytes(), 0, bytes.length);
        reader.read(message, commands::add, problems::add);
    }
}
