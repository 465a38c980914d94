package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.simulator.SimulationControl;

class StudioRequestReaderTest {

    private static StudioRequest read(String text) {
        return StudioRequestReader.read(text.replace('\'', '"'));
    }

    @Test
    void allCommandsAreRead() {
        assertThat(read("{'do':'seen'}")).isEqualTo(new StudioRequest.Seen());
        assertThat(read("{'do':'pause'}")).isEqualTo(orders(new Order.Pause()));
        assertThat(read("{'do':'resume'}")).isEqualTo(orders(new Order.Resume()));
        assertThat(read("{'do':'step','cycles':5}")).isEqualTo(orders(new Order.Step(5)));
        assertThat(read("{'do':'speed','factor':0.5}")).isEqualTo(orders(new Order.SetSpeed(0.5)));
        assertThat(read("{'do':'speed','factor':'fastest'}"))
                .isEqualTo(orders(new Order.SetSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)));
        assertThat(read("{'do':'reset'}")).isEqualTo(change("reset", new Order.Reset()));
        assertThat(read("{'do':'placeBall','x':1,'y':-2,'z':0.1}"))
                .isEqualTo(change("ball moved", new Order.MoveBall(new Vector3(1, -2, 0.1), Vector3.ZERO)));
        assertThat(read("{'do':'throwBall','x':1,'y':-2,'z':3,'gesture':7}"))
                .isEqualTo(new StudioRequest.Change(
                        "ball thrown",
                        7,
                        List.of(new Order.MoveBall(Optional.empty(), Optional.of(new Vector3(1, -2, 3))))));
        assertThat(read("{'do':'placeRobot','side':'right','number':3,'x':1,'y':2,'z':0.4,'headingDegrees':-90}"))
                .isEqualTo(change(
                        "robot moved",
                        new Order.PlaceRobot(new PlayerNumber(TeamSide.RIGHT, 3), new Vector3(1, 2, 0.4), -90)));
        assertThat(read("{'do':'kickOff','side':'left'}"))
                .isEqualTo(change(
                        "kick-off",
                        new Order.KickOff(TeamSide.LEFT),
                        new Order.MoveBall(new Vector3(0, 0, 0.042), Vector3.ZERO)));
        assertThat(read("{'do':'dropBall'}")).isEqualTo(change("ball dropped", new Order.DropBall()));
        assertThat(read("{'do':'playMode','mode':'PlayOn'}"))
                .isEqualTo(change("play mode changed", new Order.ChangePlayMode(PlayMode.PLAY_ON)));
        assertThat(read("{'do':'undo'}")).isEqualTo(StudioRequest.History.UNDO);
        assertThat(read("{'do':'redo'}")).isEqualTo(StudioRequest.History.REDO);
    }

    private static StudioRequest change(String name, Order... orders) {
        return new StudioRequest.Change(name, orders);
    }

    private static StudioRequest orders(Order... orders) {
        return new StudioRequest.Orders(orders);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "[]", "7", "{", "{'do':", "null", "'text'"})
    void invalidJsonIsRefused(String text) {
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("The studio cannot read \"" + text.replace('\'', '"') + "\". Reload the page.");
    }

    @ParameterizedTest
    @CsvSource({"{'do':'fly'}, fly", "{}, ''", "{'do':7}, 7", "{'do':{}}, ''"})
    void unknownCommandsAreRefused(String text, String name) {
        assertThatThrownBy(() -> read(text)).hasMessage("Unknown command \"" + name + "\". Reload the page.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-3", "'NaN'", "1e99", "'many'", "[]", "{}", "null", "true"})
    void stepsOutOfRangeAreRefused(String cycles) {
        assertThatThrownBy(() -> read("{'do':'step','cycles':" + cycles + "}"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("The value " + cycles.replace('\'', '"')
                        + " for \"cycles\" of \"step\" is out of range. Choose a value from 1.0 to 50000.0.");
    }

    @Test
    void missingNumbersAreRefused() {
        assertThatThrownBy(() -> read("{'do':'placeBall','x':1,'y':2}"))
                .hasMessage(
                        "The value null for \"z\" of \"placeBall\" is out of range. Choose a value from 0.0 to 50.0.");
    }

    @Test
    void unknownSideIsRefused() {
        assertThatThrownBy(() -> read("{'do':'kickOff','side':'up'}"))
                .hasMessage("The side \"up\" does not exist. Choose \"left\" or \"right\".");
    }

    @Test
    void unknownPlayModeIsRefused() {
        assertThatThrownBy(() -> read("{'do':'playMode','mode':'Tea_Break'}"))
                .hasMessage("The play mode \"Tea_Break\" does not exist. Choose one from the list.");
    }
}
