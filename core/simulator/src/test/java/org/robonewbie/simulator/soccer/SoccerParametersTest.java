package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;

class SoccerParametersTest {

    @Test
    void profilesDescribeTheirPitches() {
        assertThat(SoccerParameters.league().field()).isEqualTo(SoccerField.LEAGUE);
        assertThat(SoccerParameters.beginner().field()).isEqualTo(SoccerField.BEGINNER);
    }

    @Test
    void assignmentChangesOneValue() {
        SoccerParameters changed =
                SoccerParameters.league().with("RuleHalfTime=60").with("UseCharging=false");

        assertThat(changed.get(SoccerParameter.RULE_HALF_TIME)).isEqualTo(60);
        assertThat(changed.isOn(SoccerParameter.USE_CHARGING)).isFalse();
        assertThat(changed.get(SoccerParameter.FIELD_LENGTH)).isEqualTo(30);
    }

    @Test
    void assignmentsCanBeReadAgain() {
        SoccerParameters original = SoccerParameters.league().with("BeamNoiseXY=0.07");
        SoccerParameters copy = SoccerParameters.beginner();
        for (String assignment : original.assignments()) {
            copy = copy.with(assignment);
        }

        assertThat(copy).isEqualTo(original);
    }

    @Test
    void unknownNameIsAnsweredWithTheNearestOne() {
        assertThatThrownBy(() -> SoccerParameters.league().with("BeamNoiseXZ=1"))
                .hasMessage("Parameter \"BeamNoiseXZ\" does not exist. Did you mean BeamNoiseXY? \"robonewbie simulator"
                        + " --help\" lists all of them.");
    }

    @Test
    void missingValueIsAnsweredWithAnExample() {
        assertThatThrownBy(() -> SoccerParameters.league().with("RuleHalfTime"))
                .hasMessage("Setting \"RuleHalfTime\" has no value. Write NAME=VALUE, for example RuleHalfTime=60.");
    }

    @Test
    void textInsteadOfNumberIsRefused() {
        assertThatThrownBy(() -> SoccerParameters.league().with("RuleHalfTime=long"))
                .hasMessage(
                        "Value \"long\" of RuleHalfTime is not a number. Write, for example, RuleHalfTime=300 (length of a half, seconds).");
        assertThatThrownBy(() -> SoccerParameters.league().with("RuleHalfTime=NaN"))
                .hasMessageContaining("not a number");
    }

    @Test
    void yesOrNoIsWrittenAsTrueOrFalse() {
        assertThatThrownBy(() -> SoccerParameters.league().with("UseCharging=yes"))
                .hasMessage("Value \"yes\" of UseCharging is neither true nor false. Write true or false.");
    }

    @Test
    void negativeSizeIsRefused() {
        assertThatThrownBy(() -> SoccerParameters.league().with("FieldLength=-3"))
                .hasMessage("Value -3 of FieldLength is too small. It must be greater than 0.");
        assertThatThrownBy(() -> SoccerParameters.league().with("FoulHoldTime=-1"))
                .hasMessage("Value -1 of FoulHoldTime is too small. It must be at least 0.");
    }

    @Test
    void descriptionNamesEveryParameter() {
        assertThat(SoccerParameters.describe()).hasSameSizeAs(SoccerParameter.values());
        assertThat(SoccerParameters.describe().get(0)).contains("FieldLength", "30", "12", "metres");
    }
}
