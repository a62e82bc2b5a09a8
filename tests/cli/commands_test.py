"""Every command explains itself and does its small job."""
import json

from scene import Scene, main


class Commands(Scene):
    def test_every_command_has_a_help_that_names_its_options(self):
        for command in ("run", "list", "describe", "explain", "check", "new", "schema", "bench"):
            self.assertIn("--help", self.riffle(command, "--help").stdout, command)

    def test_without_a_command_the_exit_code_is_that_of_bad_input(self):
        self.riffle(code=2)

    def test_list_shows_the_shipped_plugins_by_kind(self):
        text = self.riffle("list").stdout
        for word in ("equations", "swe-standard", "kernel", "cubic-spline", "viscosity", "monaghan", "boundary",
                     "mirror-wall", "reference", "ritter", "stoker"):
            self.assertIn(word, text)

    def test_describe_gives_unit_default_range_and_source(self):
        text = self.riffle("describe", "monaghan").stdout
        self.assertIn("alpha", text)
        self.assertIn("[0, 100]", text)
        self.assertIn("Monaghan (1992)", text)

    def test_describe_of_an_unknown_plugin_suggests_the_nearest_name(self):
        self.assertIn('did you mean "monaghan"', self.riffle("describe", "monagan", code=2).stderr)

    def test_explain_shows_sweeps_fields_limits_and_cost(self):
        text = self.riffle("explain", self.case()).stdout
        for word in ("sweep 1", "swe-standard: momentum", "bytes/particle", "monaghan: viscous", "CPU per step"):
            self.assertIn(word, text)

    def test_schema_is_json_and_knows_a_plugin_parameter(self):
        schema = self.riffle("schema").stdout
        json.loads(schema)
        self.assertIn("lattice_normalised", schema)

    def test_bench_boundary_writes_the_figures_that_scripts_rely_on(self):
        self.riffle("bench", "boundary", "--along", 40, "--repeats", 1, "--json", "bench.json")
        figures = json.loads((self.home / "bench.json").read_text())
        for key in ("fused_cells_ns_per_pair", "fused_best_ns_per_pair", "plugins_ns_per_pair", "price", "gain"):
            self.assertGreater(figures[key], 0)
        self.assertLess(figures["relative_difference"], 1e-12)


if __name__ == "__main__":
    main()
