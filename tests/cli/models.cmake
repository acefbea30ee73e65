airlight_cli_help(models)
airlight_cli_test("models: the reference and the tables are there" OUT "^reference,all orders," "^tables," COMMAND models)
