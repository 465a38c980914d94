package org.robonewbie.protocol.order;

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

class TrainerOrderWriterTest {

    private static final PlayerNumber RIGHT_11 = new PlayerNumber(TeamSide.RIGHT, 11);

    static List<Order.Trainer> everyCommand() {
        return List.of(
                new Order.KickOff(Optional.empty()),
                new Order.KickOff(Optional.of(TeamSide.LEFT)),
                new Order.ChangePlayMode(PlayMode.DIRECT_FREE_KICK_RIGHT),
                new Order.DropBall(),
                new Order.MoveBall(Optional.of(new Vector3(1.5, -0.25, 1e-5)), Optional.empty()),
                new Order.MoveBall(Optional.empty(), Optional.of(new Vector3(-8, 0, 4))),
                new Order.MoveBall(Optional.of(Vector3.ZERO), Optional.of(Vector3.ZERO)),
                new Order.MoveRobot(RIGHT_11, new Vector3(1, 2, 0.385)),
                new Order.MoveAndTurnRobot(RIGHT_11, new Vector3(1, 2, 0.385), -90.5),
                new Order.RepelSelectedRobot(),
                new Order.SelectRobot(RIGHT_11),
                new Order.SelectNextRobot(),
                new Order.SelectNoRobot(),
                new Order.KillRobot(Optional.empty()),
                new Order.KillRobot(Optional.of(RIGHT_11)),
                new Order.RepositionRobot(Optional.empty()),
                new Order.RepositionRobot(Optional.of(RIGHT_11)),
                new Order.EndSimulation(),
                new Order.RequestFullState(),
                new Order.SetTime(299.98),
                new Order.SetScore(3, 2));
    }

    @ParameterizedTest
    @MethodSource("everyCommand")
    void serverReadsWhatATrainerWrites(Order.Trainer command) {
        MessageBuffer message = new MessageBuffer();

        new TrainerOrderWriter(message).write(command);

        assertThat(new TrainerOrderReader().read(message)).containsExactly(command);
    }

    @Test
    void severalCommandsGoIntoOneMessage() {
        MessageBuffer message = new MessageBuffer();
        TrainerOrderWriter writer = new TrainerOrderWriter(message);

        everyCommand().forEach(writer::write);

        assertThat(new TrainerOrderReader().read(message)).isEqualTo(everyCommand());
    }

    @Test
    void commandLooksAsServersKnowIt() {
        MessageBuffer message = new MessageBuffer();

        new TrainerOrderWriter(message).write(new Order.MoveAndTurnRobot(RIGHT_11, new Vector3(1, 2.5, 0.4), -90));

        assertThat(message).hasToString("(agent(unum 11)(team Right)(move 1 2.5 0.4 -90))");
    }
}
