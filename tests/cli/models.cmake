airlight_cli_help(models)
airlight_cli_test("models: the reference, the tables and published models are there" OUT "^reference,\"all orders\"," "^tables," "^preetham1999,.*,0,90,90,no,Preetham1999$" COMMAND models)
