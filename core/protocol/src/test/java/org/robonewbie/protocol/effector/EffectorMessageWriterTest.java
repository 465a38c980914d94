package org.robonewbie.protocol.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
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

class EffectorMessageWriterTest {

    @SuppressWarnings("unused")
    private static final List<EffectorCommand> COMMANDS = List.of(
            new CreateRobot("rsg/agent/nao/nao_hetero.rsg", List.of("4")),
            new JoinTeam(0, "Stars"),
            new Beam(new Pose2d(-1, 0.5, -90)),
            new SetHingeSpeed("lle7", -6.13954),
            new Say("hello!"),
            new RequestPass(),
            new Synchronise());

    private final MessageBuffer message = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(message);

    @Test
    void writesWhatServersExpect() {
        writer.createRobot("rsg/agent/nao/nao.rsg", List.of())
                .joinTeam(1, "Stars")
                .beam(new Pose2d(-1, 0.5, 90))
                .hingeSpeed("he1", 0.25)
                .say("hello")
                .requestPass()
                .synchronise();

        assertThat(message)
                .hasToString("(scene rsg/agent/nao/nao.rsg)(init (unum 1)(teamname Stars))(beam -1 0.5 90)(he1 0.25)"
                        + "(say hello)(pass)(syn)");
    }

    @ParameterizedTest
    @FieldSource("COMMANDS")
    void writesEachCommandSoThatItIsReadTheSame(EffectorCommand command) {
        writer.write(command);

        assertThat(read()).containsExactly(command);
    }

    @Property
    void writesSpeedsWithoutExponentAndNearlyExactly(@ForAll @DoubleRange(min = -1000, max = 1000) double speed) {
        message.clear();
        writer.hingeSpeed("lle4", speed);

        assertThat(message.toString()).matches("\\(lle4 -?\\d+(\\.\\d+)?\\)");
        SetHingeSpeed read = (SetHingeSpeed) read().get(0);
        assertThat(read.radiansPerSecond()).isCloseTo(speed, within(5.1e-10));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void refusesSpeedsThatAreNoNumbers(double speed) {
        assertThatThrownBy(() -> writer.hingeSpeed("lle4", speed))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Speed of lle4 is " + speed + ", not a finite number. Was something divided by zero?");
        assertThat(message.length()).isZero();
    }

    @Test
    void refusesABeamToNowhere() {
        assertThatThrownBy(() -> writer.beam(new Pose2d(0, Double.NaN, 0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("Beam y is NaN");
        assertThat(message.length()).isZero();
    }

    @Test
    void refusesToSayNothing() {
        assertThatThrownBy(() -> writer.say(""))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("A robot cannot say an empty text. Use 1 to 20 characters.");
    }

    @Test
    void refusesLongTexts() {
        assertThatThrownBy(() -> writer.say("123456789012345678901"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("A robot can say at most 20 characters, but \"123456789012345678901\" has 21."
                        + " Make it shorter.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"two words", "(syn)", "gr\u00fcn", "tab\t", "a;b", "\"a\"", "it's"})
    void refusesTextsWithCharactersThatDoNotGetThrough(String text) {
        assertThatThrownBy(() -> writer.say(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("because of the character")
                .hasMessageContaining(text);
        assertThat(message.length()).isZero();
    }

    @Test
    void refusesTeamNamesThatDoNotGetThrough() {
        assertThatThrownBy(() -> writer.joinTeam(1, "My Team"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "Team name \"My Team\" cannot be sent because of the character ' '. Use ASCII letters, digits"
                                + " and punctuation, without spaces, parentheses, semicolons or quotation marks.");
        assertThat(message.length()).isZero();
    }

    @Test
    void refusesAnEmptyTeamName() {
        assertThatThrownBy(() -> writer.joinTeam(1, ""))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Team name is empty. Use at least one character.");
    }

    private List<EffectorCommand> read() {
        List<EffectorCommand> commands = new ArrayList<>();
        new EffectorMessageReader().read(message, commands::add, problem -> {
            throw new AssertionError(problem);
        });
        return commands;
    }
}
