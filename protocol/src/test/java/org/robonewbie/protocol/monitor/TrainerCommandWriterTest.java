package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;

class TrainerCommandWriterTest {

    private static final PlayerNumber RIGHT_11 = new PlayerNumber(TeamSide.RIGHT, 11);

    static List<TrainerCommand> everyCommand() {
        return List.of(
                new TrainerCommand.KickOff(Optional.empty()),
                new TrainerCommand.KickOff(Optional.of(TeamSide.LEFT)),
                new TrainerCommand.ChangePlayMode(PlayMode.DIRECT_FREE_KICK_RIGHT),
                new TrainerCommand.DropBall(),
                new TrainerCommand.MoveBall(Optional.of(new Vector3(1.5, -0.25, 1e-5)), Optional.empty()),
                new TrainerCommand.MoveBall(Optional.empty(), Optional.of(new Vector3(-8, 0, 4))),
                new TrainerCommand.MoveBall(Optional.of(Vector3.ZERO), Optional.of(Vector3.ZERO)),
                new TrainerCommand.MoveRobot(RIGHT_11, new Vector3(1, 2, 0.385)),
                new TrainerCommand.MoveAndTurnRobot(RIGHT_11, new Vector3(1, 2, 0.385), -90.5),
                new TrainerCommand.RepelSelectedRobot(),
                new TrainerCommand.SelectRobot(RIGHT_11),
                new TrainerCommand.SelectNextRobot(),
                new TrainerCommand.SelectNoRobot(),
                new TrainerCommand.KillRobot(Optional.empty()),
                new TrainerCommand.KillRobot(Optional.of(RIGHT_11)),
                new TrainerCommand.RepositionRobot(Optional.empty()),
                new TrainerCommand.RepositionRobot(Optional.of(RIGHT_11)),
                new TrainerCommand.EndSimulation(),
                new TrainerCommand.RequestFullState(),
                new TrainerCommand.SetTime(299.98),
                new TrainerCommand.SetScore(3, 2));
    }

    @ParameterizedTest
    @MethodSource("everyCommand")
    void serverReadsWhatATrainerWrites(TrainerCommand command) {
        MessageBuffer message = new MessageBuffer();

        new TrainerCommandWriter(message).write(command);

        assertThat(new TrainerCommandReader().read(message)).containsExactly(command);
    }

    @Test
    void severalCommandsGoIntoOneMessage() {
        MessageBuffer message = new MessageBuffer();
        TrainerCommandWriter writer = new TrainerCommandWriter(message);

        everyCommand().forEach(writer::write);

        assertThat(new TrainerCommandReader().read(message)).isEqualTo(everyCommand());
    }

    @Test
    void commandLooksAsServersKnowIt() {
        MessageBuffer message = new MessageBuffer();

        new TrainerCommandWriter(message)
                .write(new TrainerCommand.MoveAndTurnRobot(RIGHT_11, new Vector3(1, 2.5, 0.4), -90));

        assertThat(message).hasToString("(agent(unum 11)(team Right)(move 1 2.5 0.4 -90))");
    }
}
